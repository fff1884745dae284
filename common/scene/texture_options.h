// Effects of a material file's options on a texture's numbers.
#pragma once
#include "common/image/image.h"
#include "common/scene/material.h"

namespace lightwalk {

/// The channel that -imfchan names in red, green and blue, and -mm's base + gain times each number.
TexelImage with_options(TexelImage image, const TextureMap& map);

/// A normal map of a bump map: the slopes of heights in which black to white is `multiplier` times four texels. An image
/// that holds normals already, as some programs write after map_Bump, is kept.
TexelImage normals_of(TexelImage image, float multiplier);

/// Green of the one's red, blue of the other's, of the larger one's size; an image without texels is white.
TexelImage roughness_and_metalness(const TexelImage& roughness, const TexelImage& metalness);

}  // namespace lightwalk
