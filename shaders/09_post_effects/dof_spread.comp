// Each tile learns of the discs around it that reach it.
#include "09_post_effects/dof_now.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar) uniform DofNowBlock { DofNow dof_now; };
uniform sampler2D tiles;
layout(rg16f) writeonly uniform image2D reached;

void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy), size = textureSize(tiles, 0);
    if (any(greaterThanEqual(tile, size))) return;
    int reach = int(dof_now.reach);
    vec2 widest = texelFetch(tiles, tile, 0).rg;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            vec2 other = texelFetch(tiles, clamp(tile + ivec2(x, y), ivec2(0), size - 1), 0).rg;
            // A tile is 16 pixels wide: the distance between the nearest points of two tiles.
            vec2 between = 16.0 * max(abs(vec2(x, y)) - 1.0, 0.0);
            if (0.5 * other.x >= length(between)) widest.x = max(widest.x, other.x);
        }
    imageStore(reached, tile, vec4(widest, 0.0, 0.0));
}
