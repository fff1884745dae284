#include "common/scene/gltf_file.h"

#include <array>
#include <cctype>
#include <cstring>
#include <optional>

#include "common/base/files.h"
#include "common/scene/asset_path.h"

namespace lightwalk {
namespace {
using nlohmann::json;

// RFC 4648, section 4. Padding may be missing, and blanks, where some writers break lines, are skipped; empty: other
// characters.
std::optional<std::string> decode_base64(std::string_view text) {
    std::string out;
    uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        if (std::isspace(static_cast<unsigned char>(c))) continue;
        const size_t digit =
            std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/").find(c);
        if (digit == std::string_view::npos) return {};
        bits = bits << 6 | static_cast<uint32_t>(digit);
        if ((count += 6) >= 8) out += static_cast<char>(bits >> (count -= 8) & 255u);
    }
    return out;
}

template <class T>
T read_as(const char* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

// glTF 2.0, 3.6.2.2. `most`: divisor for normalised integers.
struct ComponentType {
    int code;
    size_t bytes;
    float most;
};
constexpr std::array<ComponentType, 6> component_types{
    {{5120, 1, 127}, {5121, 1, 255}, {5122, 2, 32767}, {5123, 2, 65535}, {5125, 4, 0}, {5126, 4, 0}}};

const ComponentType* component_type(int code) {
    for (const ComponentType& type : component_types)
        if (type.code == code) return &type;
    return nullptr;
}

template <class T>
T component(const char* p, int code) {
    switch (code) {
        case 5120:
            return static_cast<T>(read_as<int8_t>(p));
        case 5121:
            return static_cast<T>(read_as<uint8_t>(p));
        case 5122:
            return static_cast<T>(read_as<int16_t>(p));
        case 5123:
            return static_cast<T>(read_as<uint16_t>(p));
        case 5125:
            return static_cast<T>(read_as<uint32_t>(p));
        default:
            return static_cast<T>(read_as<float>(p));
    }
}

size_t components_of(const std::string& type) {
    static const std::map<std::string, size_t> known = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                        {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    const auto found = known.find(type);
    return found == known.end() ? 0 : found->second;
}

}  // namespace

const json* extension(const json& object, const char* name) {
    const auto all = object.find("extensions");
    if (all == object.end() || !all->is_object()) return nullptr;
    const auto one = all->find(name);
    return one == all->end() || !one->is_object() ? nullptr : &*one;
}

GltfFile::GltfFile(const std::filesystem::path& file) : path(file) {
    read_container();
    if (!root.is_object()) refuse("its JSON is no object, expected a glTF file");
    check_version();
}

// GLB: 12-byte header, JSON chunk, binary chunk, each chunk preceded by length and type.
void GltfFile::read_container() {
    text_ = read_file(path);
    std::string_view text = text_;
    if (text.starts_with("glTF")) {
        if (text.size() < 20) refuse("the file ends within its header");
        if (const auto version = read_as<uint32_t>(&text[4]); version != 2)
            refuse("binary glTF {}, expected 2", version);
        // Bytes behind the stated length are no part of the file.
        if (const size_t length = read_as<uint32_t>(&text[8]); length >= 20 && length < text.size())
            text = text.substr(0, length);
        std::string_view json_text;
        for (size_t at = 12; at + 8 <= text.size();) {
            const size_t bytes = read_as<uint32_t>(&text[at]);
            const std::string_view kind = text.substr(at + 4, 4);
            if (bytes > text.size() - at - 8) refuse("the file ends within a chunk");
            if (kind == "JSON" && json_text.empty()) json_text = text.substr(at + 8, bytes);
            if (kind == std::string_view("BIN\0", 4) && !has_binary_) {
                binary_ = text.substr(at + 8, bytes);
                has_binary_ = true;
            }
            // A length that is no multiple of four was written without its padding, or stands for the padded one.
            const size_t end = at + 8 + bytes, padded = at + 8 + (bytes + 3) / 4 * 4;
            const auto begins_chunk = [&](size_t place) {
                return place + 8 <= text.size() && text.substr(place + 4, 4) == std::string_view("BIN\0", 4);
            };
            at = begins_chunk(end) && !begins_chunk(padded) ? end : padded;
        }
        text = json_text;
    }
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    root = json::parse(text);
}

void GltfFile::check_version() const {
    const auto asset = root.find("asset");
    if (asset == root.end() || !asset->is_object()) refuse("no 'asset', expected a glTF file");
    const std::string version = value_or<std::string>(*asset, "version", "");
    if (!version.starts_with("2.")) refuse("glTF version '{}', expected 2.0", version);
    const std::string needed = value_or<std::string>(*asset, "minVersion", "2.0");
    if (needed != "2.0") refuse("needs a reader of glTF {}, this one reads 2.0", needed);
}

size_t GltfFile::count(const char* list) const {
    const auto found = root.find(list);
    return found == root.end() ? 0 : found->size();
}

const json& GltfFile::entry(const char* list, size_t index) const {
    if (index >= count(list))
        refuse("{} {} is named, there {} {}", list, index, count(list) == 1 ? "is" : "are", count(list));
    return root.at(list).at(index);
}

std::string GltfFile::read_uri(const std::string& uri) const {
    if (uri.starts_with("data:")) {
        const size_t comma = uri.find(',');
        if (comma == uri.npos) refuse("a data URI without data");
        std::string data = decode_uri(std::string_view(uri).substr(comma + 1));
        if (!std::string_view(uri).substr(0, comma).ends_with(";base64")) return data;
        std::optional<std::string> bytes = decode_base64(data);
        if (!bytes) refuse("a data URI that is not base64");
        return std::move(*bytes);
    }
    try {
        return read_file(resolve_uri(uri, path.parent_path()));
    } catch (const InputError& e) { refuse("{}", e.what()); }
}

std::string_view GltfFile::buffer(size_t index) const {
    if (const auto known = buffers_.find(index); known != buffers_.end()) return known->second;
    const json& from = entry("buffers", index);
    const auto uri = from.find("uri");
    const bool binary = uri == from.end() && index == 0 && has_binary_;
    std::string bytes;
    if (uri != from.end())
        bytes = read_uri(uri->get<std::string>());
    else if (!binary)
        refuse("buffer {} names no file", index);
    const size_t size = binary ? binary_.size() : bytes.size();
    if (const size_t length = from.at("byteLength").get<size_t>(); size < length)
        refuse("buffer {} has {} bytes, the file says {}", index, size, length);
    if (binary) return binary_;
    return buffers_[index] = std::move(bytes);
}

std::string_view GltfFile::view(size_t index) const {
    const json& from = entry("bufferViews", index);
    const json* packed = extension(from, "EXT_meshopt_compression");
    if (!packed) packed = extension(from, "KHR_meshopt_compression");
    if (packed) {
        auto known = decompressed_.find(index);
        if (known == decompressed_.end()) known = decompressed_.emplace(index, decompressed(*packed)).first;
        return known->second;
    }
    const std::string_view bytes = buffer(from.at("buffer").get<size_t>());
    const size_t offset = value_or<size_t>(from, "byteOffset", 0), length = from.at("byteLength").get<size_t>();
    if (offset > bytes.size() || length > bytes.size() - offset)
        refuse("buffer view {} reaches beyond its buffer's {} bytes", index, bytes.size());
    return bytes.substr(offset, length);
}

std::string_view GltfFile::slice(size_t index, size_t offset, size_t bytes, const char* what) const {
    const std::string_view all = view(index);
    if (offset > all.size() || bytes > all.size() - offset)
        refuse("{} reaches beyond the {} bytes of buffer view {}", what, all.size(), index);
    return all.substr(offset, bytes);
}

GltfFile::Accessor GltfFile::accessor(size_t index) const {
    const json& from = entry("accessors", index);
    Accessor a{};
    a.count = from.at("count").get<size_t>();
    a.type = from.at("componentType").get<int>();
    a.components = components_of(from.at("type").get<std::string>());
    a.normalized = value_or(from, "normalized", false);
    const ComponentType* type = component_type(a.type);
    if (!type || a.components == 0) refuse("accessor {} has an unknown type", index);
    a.component_bytes = type->bytes;
    const size_t bytes = a.components * a.component_bytes;
    a.stride = bytes;
    if (a.count > most_values) refuse("accessor {} counts {}", index, a.count);
    const auto view_index = from.find("bufferView");
    if (view_index == from.end()) return a;
    const size_t number = view_index->get<size_t>();
    a.stride = value_or<size_t>(entry("bufferViews", number), "byteStride", bytes);
    if (a.stride < bytes || a.stride > 252 + bytes) refuse("buffer view {} has a stride of {} bytes", number, a.stride);
    if (a.count > 0)
        a.bytes = slice(number, value_or<size_t>(from, "byteOffset", 0), (a.count - 1) * a.stride + bytes,
                        fmt::format("accessor {}", index).c_str());
    return a;
}

size_t GltfFile::components(size_t index) const {
    return components_of(entry("accessors", index).at("type").get<std::string>());
}

size_t GltfFile::length(size_t index) const { return accessor(index).count; }

// `out` must be zero-initialised; elements are `step` values apart.
template <class T>
void GltfFile::read(size_t index, size_t components, T* out, size_t step) const {
    const Accessor a = accessor(index);
    if (a.components != components)
        refuse("accessor {} has {} components, expected {}", index, a.components, components);
    const float most = component_type(a.type)->most;
    const auto value = [&](const char* p) {
        const T given = component<T>(p, a.type);
        return std::is_same_v<T, float> && a.normalized && most > 0 ? std::max(given / T(most), T(-1)) : given;
    };
    for (size_t i = 0; !a.bytes.empty() && i < a.count; ++i)
        for (size_t c = 0; c < components; ++c)
            out[i * step + c] = value(a.bytes.data() + i * a.stride + c * a.component_bytes);
    const json& from = entry("accessors", index);
    if (const auto sparse = from.find("sparse"); sparse != from.end()) {
        const json &at = sparse->at("indices"), &with = sparse->at("values");
        const size_t count = sparse->at("count").get<size_t>(), bytes = components * a.component_bytes;
        const int code = at.at("componentType").get<int>();
        const ComponentType* type = component_type(code);
        if (!type || code == 5126 || count > a.count) refuse("accessor {} has sparse values that do not fit", index);
        const std::string_view places = slice(at.at("bufferView").get<size_t>(), value_or<size_t>(at, "byteOffset", 0),
                                              count * type->bytes, "a sparse accessor");
        const std::string_view values =
            slice(with.at("bufferView").get<size_t>(), value_or<size_t>(with, "byteOffset", 0), count * bytes,
                  "a sparse accessor");
        for (size_t i = 0; i < count; ++i) {
            const size_t place = component<uint32_t>(places.data() + i * type->bytes, code);
            if (place >= a.count) refuse("accessor {} has a sparse value {}, it counts {}", index, place, a.count);
            for (size_t c = 0; c < components; ++c)
                out[place * step + c] = value(values.data() + i * bytes + c * a.component_bytes);
        }
    }
}

template void GltfFile::read(size_t, size_t, float*, size_t) const;

std::vector<float> GltfFile::floats(size_t index, size_t components) const {
    std::vector<float> out(length(index) * components);
    read(index, components, out.data(), components);
    return out;
}

std::vector<uint32_t> GltfFile::integers(size_t index, size_t components) const {
    const int type = accessor(index).type;
    if (type != 5121 && type != 5123 && type != 5125) refuse("accessor {} does not hold unsigned integers", index);
    std::vector<uint32_t> out(length(index) * components);
    read(index, components, out.data(), components);
    return out;
}

}  // namespace lightwalk
