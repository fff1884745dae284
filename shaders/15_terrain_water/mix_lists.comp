// Each pixel's list, sorted by depth, over the background. The nearest fragments are kept where there are too many.
#include "15_terrain_water/transparency_data.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) readonly buffer ListHeadsBuffer { uint list_heads[]; };
layout(scalar) readonly buffer ListedBuffer { ListedFragment listed[]; };
layout(rgba16f) uniform image2D picture;

const int most_sorted = 32;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(picture);
    if (any(greaterThanEqual(at, size))) return;
    uint next = list_heads[at.y * size.x + at.x];
    if (next == 0u) return;

    // 1. By insertion, the nearest first.
    float depths[most_sorted];
    uint places[most_sorted];
    int count = 0;
    for (; next != 0u; next = listed[next - 1u].next) {
        float depth = listed[next - 1u].depth;
        if (count == most_sorted && depth <= depths[most_sorted - 1]) continue;
        int to = count < most_sorted ? count++ : most_sorted - 1;
        for (; to > 0 && depths[to - 1] < depth; --to) {
            depths[to] = depths[to - 1];
            places[to] = places[to - 1];
        }
        depths[to] = depth;
        places[to] = next - 1u;
    }

    // 2. Front to back, with the remaining transmittance.
    vec3 sum = vec3(0.0);
    float left = 1.0;
    for (int i = 0; i < count; ++i) {
        ListedFragment f = listed[places[i]];
        vec2 blue_alpha = unpackHalf2x16(f.blue_alpha);
        sum += left * blue_alpha.y * vec3(unpackHalf2x16(f.red_green), blue_alpha.x);
        left *= 1.0 - blue_alpha.y;
    }
    vec4 before = imageLoad(picture, at);
    imageStore(picture, at, vec4(sum + left * before.rgb, before.a));
}
