// Integrals of GGX over lights, by view and roughness: assets/tables/ggx.pfm as images.
#pragma once
#include "common/gpu/gpu.h"
#include "common/image/image.h"

namespace lightwalk {

/// Columns: √(1 - n·v) from 1 to 0. Rows: roughness from 0 to 1.
struct GgxTable {
    static constexpr int size = 64;  ///< width and height in texels

    Image cosines;  ///< inverse LTC matrix: elements (1, 1), (1, 3), (3, 1), (3, 3); (2, 2) is 1
    Image albedos;  ///< A and B of the split sum: under white light a surface reflects f0 A + B

    void load(Gpu& gpu);  ///< once
};

}  // namespace lightwalk
