// Supported glTF extensions, and detection of the others.
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <set>

#include "common/scene/gltf_parts.h"

namespace lightwalk {
namespace {
using nlohmann::json;

// Supported extensions, and those without visual effect.
constexpr std::array<std::string_view, 16> drawn = {"KHR_materials_unlit",
                                                    "KHR_materials_emissive_strength",
                                                    "KHR_materials_pbrSpecularGlossiness",
                                                    "KHR_materials_transmission",
                                                    "KHR_materials_volume",
                                                    "KHR_texture_transform",
                                                    "KHR_mesh_quantization",
                                                    "KHR_draco_mesh_compression",
                                                    "EXT_texture_webp",
                                                    "EXT_meshopt_compression",
                                                    "KHR_meshopt_compression",
                                                    "KHR_lights_punctual",
                                                    "EXT_mesh_gpu_instancing",
                                                    "KHR_node_visibility",
                                                    "KHR_xmp",
                                                    "KHR_xmp_json_ld"};

bool is_drawn(std::string_view name) { return std::find(drawn.begin(), drawn.end(), name) != drawn.end(); }

// Names of extensions anywhere in a value. Iterative, since files may nest arbitrarily deep.
std::set<std::string> extensions_in(const json& value) {
    std::set<std::string> names;
    std::vector<const json*> waiting = {&value};
    while (!waiting.empty()) {
        const json& at = *waiting.back();
        waiting.pop_back();
        if (!at.is_structured()) continue;
        for (const auto& [key, inner] : at.items()) {
            if (at.is_object() && key == "extras") continue;
            if (at.is_object() && key == "extensions" && inner.is_object())
                for (const auto& [name, ignored] : inner.items()) names.insert(name);
            waiting.push_back(&inner);
        }
    }
    return names;
}

}  // namespace

void check_gltf_required(const GltfFile& file) {
    const auto required = file.root.find("extensionsRequired");
    if (required == file.root.end()) return;
    for (const json& name : *required)
        if (!is_drawn(name.get<std::string>()) && name != "KHR_materials_variants")  // optional variants
            file.refuse("it requires the extension {}, which is not read", name.get<std::string>());
}

void list_gltf_extensions(const GltfFile& file, Model& model) {
    static constexpr std::pair<const char*, const char*> lists[] = {
        {"materials", "material"},   {"textures", "texture"}, {"meshes", "mesh"},     {"nodes", "node"},
        {"animations", "animation"}, {"images", "image"},     {"scenes", "scene"},    {"cameras", "camera"},
        {"skins", "skin"},           {"bufferViews", "view"}, {"samplers", "sampler"}};
    std::set<std::string> named;
    for (const auto& [list, unit] : lists)
        for (size_t i = 0; i < file.count(list); ++i)
            for (const std::string& name : extensions_in(file.entry(list, i)))
                if (!is_drawn(name)) {
                    leave_out(model, name, unit);
                    named.insert(name);
                }
    if (const auto used = file.root.find("extensionsUsed"); used != file.root.end())
        for (const json& name : *used)
            if (!is_drawn(name.get<std::string>()) && !named.contains(name)) leave_out(model, name);
}

// EXT_meshopt_compression
std::string GltfFile::decompressed(const json& how) const {
    const std::string_view bytes = buffer(how.at("buffer").get<size_t>());
    const size_t offset = value_or<size_t>(how, "byteOffset", 0), length = how.at("byteLength").get<size_t>();
    const size_t count = how.at("count").get<size_t>(), stride = how.at("byteStride").get<size_t>();
    const std::string mode = how.at("mode"), filter = value_or<std::string>(how, "filter", "NONE");
    if (offset > bytes.size() || length > bytes.size() - offset) refuse("compressed bytes reach beyond their buffer");
    if (stride == 0 || stride > 256 || count > most_values)
        refuse("compressed values are {} of {} bytes", count, stride);
    const bool attributes = mode == "ATTRIBUTES";
    if (attributes ? stride % 4 != 0 : stride != 2 && stride != 4) refuse("compressed {} of {} bytes", mode, stride);
    if (mode == "TRIANGLES" && count % 3 != 0) refuse("{} compressed indices of triangles", count);
    std::string out(count * stride, '\0');
    const auto* from = reinterpret_cast<const unsigned char*>(bytes.data()) + offset;
    const int failed = attributes            ? meshopt_decodeVertexBuffer(out.data(), count, stride, from, length)
                       : mode == "TRIANGLES" ? meshopt_decodeIndexBuffer(out.data(), count, stride, from, length)
                       : mode == "INDICES"   ? meshopt_decodeIndexSequence(out.data(), count, stride, from, length)
                                             : 1;
    if (failed) refuse("its compressed {} cannot be read", mode);
    if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
        meshopt_decodeFilterOct(out.data(), count, stride);
    else if (filter == "QUATERNION" && stride == 8)
        meshopt_decodeFilterQuat(out.data(), count, stride);
    else if (filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(out.data(), count, stride);
    else if (filter != "NONE")
        refuse("compressed with filter {} of {} bytes", filter, stride);
    return out;
}

}  // namespace lightwalk
