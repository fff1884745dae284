// Textures of a glTF file that are not files of the scene's own.
#pragma once
#include "common/image/image.h"
#include "common/scene/image_pool.h"

namespace lightwalk {

/// Colours with opacity in their alpha, the only place that glTF has for it: `color`'s own alpha times `opacity`'s red. As
/// large as the larger of both in each direction.
Image8 color_with_opacity(const Image8& color, const Image8& opacity);

/// A texture as a material uses it, in 8 bits. Throws InputError where it cannot be read.
Image8 picture_of(const TextureUse& use);

}  // namespace lightwalk
