// Where what can be made again is kept between runs.
#pragma once
#include <filesystem>

namespace lightwalk {

/// $LIGHTWALK_CACHE, else build/shader_cache in the tree, else one in the temporary folder. It need not be writable, and
/// what is read from it need not be what was written.
const std::filesystem::path& cache_folder();

}  // namespace lightwalk
