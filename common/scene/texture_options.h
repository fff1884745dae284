// Texture options of material files.
#pragma once
#include "common/image/image.h"
#include "common/scene/material.h"

namespace lightwalk {

/// Applies -imfchan (channel replicated to RGB) and -mm (base + gain · value).
TexelImage with_options(TexelImage image, const TextureMap& map);

/// Normal map of heights in which black to white is `multiplier` × 4 texels; normal maps are returned unchanged.
TexelImage normals_of(TexelImage image, float multiplier);

/// Packs the red channels into green and blue, at the larger size; an empty image counts as white.
TexelImage roughness_and_metalness(const TexelImage& roughness, const TexelImage& metalness);

}  // namespace lightwalk
