#include "common/scene/gltf_parts.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <draco/compression/decode.h>
#pragma GCC diagnostic pop

namespace lightwalk {
namespace {

float largest(draco::DataType type) {
    switch (type) {
        case draco::DT_INT8:
            return 127;
        case draco::DT_UINT8:
            return 255;
        case draco::DT_INT16:
            return 32767;
        case draco::DT_UINT16:
            return 65535;
        default:
            return 1;
    }
}

template <class T>
std::vector<T> values_of(const draco::Mesh& mesh, const draco::PointAttribute& from, size_t components) {
    std::vector<T> out(mesh.num_points() * components);
    for (uint32_t i = 0; i < mesh.num_points(); ++i)
        from.ConvertValue(from.mapped_index(draco::PointIndex(i)), static_cast<int8_t>(components),
                          &out[i * components]);
    return out;
}

}  // namespace

DracoPrimitive::DracoPrimitive(const GltfFile& file, const nlohmann::json& how)
    : file_(file), ids_(how.at("attributes")) {
    const std::string_view bytes = file.view(how.at("bufferView").get<size_t>());
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) file.refuse("its Draco data cannot be read: {}", decoded.status().error_msg_string());
    mesh_ = std::move(decoded).value();
}

DracoPrimitive::~DracoPrimitive() = default;

const draco::PointAttribute* DracoPrimitive::find(const std::string& attribute, size_t components) const {
    const auto id = ids_.find(attribute);
    if (id == ids_.end()) return nullptr;
    const draco::PointAttribute* const found = mesh_->GetAttributeByUniqueId(id->get<uint32_t>());
    if (!found) file_.refuse("its Draco data has no attribute {} for {}", id->get<uint32_t>(), attribute);
    if (found->num_components() != components)
        file_.refuse("{} of its Draco data has {} components, expected {}", attribute, found->num_components(),
                     components);
    return found;
}

std::optional<std::vector<float>> DracoPrimitive::floats(const std::string& attribute, size_t components,
                                                         bool is_normalized) const {
    const draco::PointAttribute* const from = find(attribute, components);
    if (!from) return {};
    std::vector<float> out = values_of<float>(*mesh_, *from, components);
    if (is_normalized && !from->normalized())
        for (float& value : out) value = std::max(value / largest(from->data_type()), -1.0f);
    return out;
}

std::optional<std::vector<uint32_t>> DracoPrimitive::integers(const std::string& attribute, size_t components) const {
    const draco::PointAttribute* const from = find(attribute, components);
    if (!from) return {};
    return values_of<uint32_t>(*mesh_, *from, components);
}

std::vector<uint32_t> DracoPrimitive::indices() const {
    std::vector<uint32_t> corners;
    for (uint32_t i = 0; i < mesh_->num_faces(); ++i)
        for (const draco::PointIndex& corner : mesh_->face(draco::FaceIndex(i))) corners.push_back(corner.value());
    return corners;
}

}  // namespace lightwalk
