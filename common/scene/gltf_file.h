// A glTF 2.0 file: its JSON, its buffers, and the numbers that accessors name in them.
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"

namespace lightwalk {

/// Throws InputError, with the file's name, for malformed content.
class GltfFile {
  public:
    using json = nlohmann::json;

    explicit GltfFile(const std::filesystem::path& path);
    GltfFile(const GltfFile&) = delete;

    const std::filesystem::path path;
    json root;

    /// "meshes", 3: that entry; refuses an index out of range.
    const json& entry(const char* list, size_t index) const;
    size_t count(const char* list) const;

    /// The numbers of an accessor, `components` each: normalised integers as floats, sparse values put in.
    std::vector<float> floats(size_t accessor, size_t components) const;
    /// The same as vectors of as many numbers.
    template <class Vector>
    std::vector<Vector> vectors(size_t accessor) const {
        std::vector<Vector> result(length(accessor));
        read_into(accessor, result.data(), sizeof(Vector));
        return result;
    }
    /// The same into vectors that lie `step_bytes` apart; there are length() of them, and they are zero.
    template <class Vector>
    void read_into(size_t accessor, Vector* first, size_t step_bytes) const {
        read(accessor, static_cast<size_t>(Vector::length()), &first->x, step_bytes / sizeof(float));
    }
    size_t length(size_t accessor) const;
    std::vector<uint32_t> integers(size_t accessor, size_t components) const;
    size_t components(size_t accessor) const;

    /// The bytes of a buffer view, decompressed; good as long as the file.
    std::string_view view(size_t index) const;

    /// The bytes of a data URI, or of a file beside this one.
    std::string read_uri(const std::string& uri) const;

    template <class... Values>
    [[noreturn]] void refuse(fmt::format_string<Values...> format, Values&&... values) const {
        throw InputError("{}: {}", path.string(), fmt::format(format, std::forward<Values>(values)...));
    }

  private:
    /// Of an accessor without bytes, which no file's length bounds.
    static constexpr size_t most_values = size_t{1} << 28;
    struct Accessor {
        size_t count, components, component_bytes, stride;
        int type;
        bool normalized;
        std::string_view bytes;  ///< none: zeros
    };
    Accessor accessor(size_t index) const;
    void read(size_t index, size_t components, float* out, size_t step) const;
    template <class T, class Read>
    void values(size_t index, size_t components, T* out, size_t step, Read read) const;
    std::string_view slice(size_t view, size_t offset, size_t bytes, const char* what) const;
    std::string_view buffer(size_t index) const;
    std::string decompressed(const json& how) const;
    void read_container();
    void check_version() const;

    std::string text_;
    std::string_view binary_;  ///< of a .glb, a part of the text
    bool has_binary_ = false;
    mutable std::map<size_t, std::string> buffers_, decompressed_;
};

/// The member of that name, or `otherwise`; refuses a value of another type.
template <class T>
T value_or(const nlohmann::json& object, const char* key, T otherwise) {
    const auto found = object.find(key);
    return found == object.end() ? otherwise : found->get<T>();
}

/// The extension's object, or null.
const nlohmann::json* extension(const nlohmann::json& object, const char* name);

/// Three or so numbers.
template <class Vector>
Vector vector_or(const nlohmann::json& object, const char* key, Vector otherwise) {
    const auto found = object.find(key);
    if (found == object.end()) return otherwise;
    for (int i = 0; i < Vector::length(); ++i) otherwise[i] = found->at(size_t(i)).get<float>();
    return otherwise;
}

}  // namespace lightwalk
