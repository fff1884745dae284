// The least and the greatest height of 2^level x 2^level cells, corners and all: of a cell from its four corners, of more
// from four of the level before.
#include "15_terrain_water/land_data.h"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D finer;
layout(scalar) uniform FromHeightsBlock { int from_heights; };
layout(rg32f) writeonly uniform image2D result;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(result)))) return;
    ivec2 first = from_heights != 0 ? at : 2 * at;
    vec2 bounds = vec2(1e9, -1e9);
    for (int i = 0; i < 4; ++i) {
        vec2 found = texelFetch(finer, first + ivec2(i & 1, i >> 1), 0).rg;
        if (from_heights != 0) found.y = found.x;
        bounds = vec2(min(bounds.x, found.x), max(bounds.y, found.y));
    }
    imageStore(result, at, vec4(bounds, 0.0, 0.0));
}
