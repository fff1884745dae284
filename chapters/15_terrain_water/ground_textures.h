// Textures of the ground: grass, forest, rock and snow.
#pragma once
#include "common/gpu/gpu.h"

namespace lightwalk {

/// Arrays of four layers (grass, forest, rock, snow) that tile, RGBA8 with all levels. `materials`: the square root of the
/// albedo, and the height of the surface (0 to 1). `bumps`: slopes along u and v in r and g, 0.5 is level, 1 a height of 1
/// in 1/32 of the tile. Rock is the photograph of a bark, turned; the others are noise.
void make_ground_textures(Gpu& gpu, Image& materials, Image& bumps);

}  // namespace lightwalk
