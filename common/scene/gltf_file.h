// glTF 2.0 file: JSON, buffers, accessors.
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"

namespace lightwalk {

/// Throws InputError, with the file name, for malformed content.
class GltfFile {
  public:
    using json = nlohmann::json;

    explicit GltfFile(const std::filesystem::path& path);
    GltfFile(const GltfFile&) = delete;

    const std::filesystem::path path;
    json root;

    /// Entry `index` of a top-level list such as "meshes". Throws InputError if out of range.
    const json& entry(const char* list, size_t index) const;
    size_t count(const char* list) const;

    /// Accessor values, `components` per element; normalised integers are converted, sparse values applied.
    std::vector<float> floats(size_t accessor, size_t components) const;
    template <class Vector>
    std::vector<Vector> vectors(size_t accessor) const {
        std::vector<Vector> result(length(accessor));
        read_into(accessor, result.data(), sizeof(Vector));
        return result;
    }
    /// Writes length(accessor) elements, `step_bytes` apart, into zero-initialised memory.
    template <class Vector>
    void read_into(size_t accessor, Vector* first, size_t step_bytes) const {
        read(accessor, static_cast<size_t>(Vector::length()), &first->x, step_bytes / sizeof(float));
    }
    size_t length(size_t accessor) const;
    std::vector<uint32_t> integers(size_t accessor, size_t components) const;
    size_t components(size_t accessor) const;

    /// Decompressed bytes of a buffer view, valid while this object lives.
    std::string_view view(size_t index) const;

    /// Contents of a data URI, or of a file relative to this one.
    std::string read_uri(const std::string& uri) const;

    template <class... Values>
    [[noreturn]] void refuse(fmt::format_string<Values...> format, Values&&... values) const {
        throw InputError("{}: {}", path.string(), fmt::format(format, std::forward<Values>(values)...));
    }

  private:
    /// Limit for accessors without a buffer, whose size the file length does not bound.
    static constexpr size_t most_values = size_t{1} << 28;
    struct Accessor {
        size_t count, components, component_bytes, stride;
        int type;
        bool normalized;
        std::string_view bytes;
    };
    Accessor accessor(size_t index) const;
    template <class T>
    void read(size_t index, size_t components, T* out, size_t step) const;
    std::string_view slice(size_t view, size_t offset, size_t bytes, const char* what) const;
    std::string_view buffer(size_t index) const;
    std::string decompressed(const json& how) const;
    void read_container();
    void check_version() const;

    std::string text_;
    std::string_view binary_;
    bool has_binary_ = false;
    mutable std::map<size_t, std::string> buffers_, decompressed_;
};

/// Value of a member, or `otherwise`. Throws json::type_error for another type.
template <class T>
T value_or(const nlohmann::json& object, const char* key, T otherwise) {
    const auto found = object.find(key);
    return found == object.end() ? otherwise : found->get<T>();
}

const nlohmann::json* extension(const nlohmann::json& object, const char* name);

template <class Vector>
Vector vector_or(const nlohmann::json& object, const char* key, Vector otherwise) {
    const auto found = object.find(key);
    if (found == object.end()) return otherwise;
    for (int i = 0; i < Vector::length(); ++i) otherwise[i] = found->at(size_t(i)).get<float>();
    return otherwise;
}

}  // namespace lightwalk
