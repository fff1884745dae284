// Textures of a glTF file that are not files of the scene's own.
#pragma once
#include <filesystem>

#include "common/image/image.h"

namespace lightwalk {

/// Colours with opacity in their alpha, the only place that glTF has for it: `color`'s own alpha times `opacity`'s red. As
/// large as the larger of both in each direction. `color` empty: white. Throws InputError where one cannot be read.
Image8 color_with_opacity(const std::filesystem::path& color, const std::filesystem::path& opacity);

}  // namespace lightwalk
