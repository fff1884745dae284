// What can be made again and is kept between runs: compiled shaders, baked textures.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace lightwalk {

/// $LIGHTWALK_CACHE, else build/shader_cache in the tree, else the user's own in the temporary folder. It need not be
/// writable. Empty where there is none: what is there under its name is another user's, or open to others.
const std::filesystem::path& cache_folder();

/// The file in cache_folder() for what `key` makes: two hashes of the key and the ending, which begins with a dot.
std::filesystem::path kept_file(std::string_view key, std::string_view ending);

/// What keep() wrote there. Nothing where there is no file, a damaged one, one of another kind, or more than `most` bytes.
std::optional<std::string> read_kept(const std::filesystem::path& file, size_t most);

/// Writes `bytes`, deflated, with their number and a checksum. A file that cannot be written is left out: the next run is
/// only slower.
void keep(const std::filesystem::path& file, std::string_view bytes);

}  // namespace lightwalk
