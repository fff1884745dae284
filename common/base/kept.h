// Cache of reproducible results between runs: compiled shaders, baked textures.
#pragma once
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace lightwalk {

/// $LIGHTWALK_CACHE, else build/shader_cache, else a private temporary folder; may be read-only; empty: unusable.
const std::filesystem::path& cache_folder();

/// Path from two hashes of `key` and `ending`, which starts with a dot.
std::filesystem::path kept_file(std::string_view key, std::string_view ending);

/// Contents written by keep(); empty if the file is missing, damaged, of another kind or larger than `most` bytes.
std::optional<std::string> read_kept(const std::filesystem::path& file, size_t most);

/// Writes `bytes` compressed, with size and checksum. Ignores write errors: the next run is only slower.
void keep(const std::filesystem::path& file, std::string_view bytes);

/// Scope in which this thread's keep() writes nothing, if `skips`.
class SkipKeeping {
  public:
    explicit SkipKeeping(bool skips);
    ~SkipKeeping();
    SkipKeeping(const SkipKeeping&) = delete;

  private:
    bool before_;
};

/// Cached values, or those of `make`, which are then cached. `key` names all inputs and the algorithm's version.
template <class T, class Make>
std::vector<T> kept_or_made(std::string_view key, std::string_view ending, size_t count, const Make& make) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::filesystem::path file = kept_file(key, ending);
    if (const auto kept = read_kept(file, count * sizeof(T)); kept && kept->size() == count * sizeof(T)) {
        std::vector<T> values(count);
        std::memcpy(static_cast<void*>(values.data()), kept->data(), kept->size());
        return values;
    }
    std::vector<T> values = make();
    keep(file, {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
    return values;
}

}  // namespace lightwalk
