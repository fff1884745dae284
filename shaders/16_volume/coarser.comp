// The pyramid over the blocks, folded into one image: how large the largest empty block is that a block lies in. 0: it is
// occupied; 1: it is empty; 2: so are all of the eight; 3: all of the 64.
#include "16_volume/volume_data.h"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
uniform sampler3D occupied;
layout(r8) writeonly uniform image3D result;

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(at, imageSize(result)))) return;
    int levels = 0;
    for (int level = 0; level < BLOCK_LEVELS && levels == level; ++level) {
        int edge = 1 << level;
        ivec3 first = at / edge * edge;
        float most = 0.0;
        for (int i = 0; i < edge * edge * edge; ++i)
            most = max(most, texelFetch(occupied, first + ivec3(i % edge, i / edge % edge, i / (edge * edge)), 0).r);
        if (most == 0.0) levels = level + 1;
    }
    imageStore(result, at, vec4(float(levels) / 255.0));
}
