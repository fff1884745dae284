// Build-time compilation of a chapter's shaders.
#pragma once
#include "common/app/chapter.h"

namespace lightwalk {

/// Compiles all variants; without `all`, those of default knobs. Writes `stamp`, and `stamp`.d for make. Throws
/// ShaderError.
int compile_all_shaders(Chapter& chapter, const std::string& stamp, bool all);

}  // namespace lightwalk
