// All shaders of a chapter, at build time.
#pragma once
#include "common/app/chapter.h"

namespace lightwalk {

/// Compiles every pipeline of the chapter in every variant of its choices and toggles (without `all`: with the default
/// knobs, all references or all starters) and validates the SPIR-V. Needs no device. Then writes the file `stamp`, and beside it `stamp`.d, which says in make's words which shaders it was
/// made from. Throws ShaderError.
int compile_all_shaders(Chapter& chapter, const std::string& stamp, bool all);

}  // namespace lightwalk
