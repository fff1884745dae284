// Each pixel's list, sorted by depth, over the background: the nearest 32, then the next 32, to the end.
#include "15_terrain_water/packed_tint.glsl"
#include "15_terrain_water/tint_through.glsl"
#include "15_terrain_water/transparency_data.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) readonly buffer ListHeadsBuffer { uint list_heads[]; };
layout(scalar) readonly buffer ListedBuffer { ListedFragment listed[]; };
layout(rgba16f) uniform image2D picture;

const int most_sorted = 32;

bool is_nearer(float depth, uint place, float than_depth, uint than_place) {
    return depth > than_depth || (depth == than_depth && place > than_place);
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(picture);
    if (any(greaterThanEqual(at, size))) return;
    uint first = list_heads[at.y * size.x + at.x];
    if (first == 0u) return;

    vec3 sum = vec3(0.0), left = vec3(1.0);
    float last_depth = 2.0;  // of the farthest that is mixed
    uint last_place = 0u;
    int count = most_sorted;
    while (count == most_sorted) {
        // 1. By insertion, the nearest first.
        float depths[most_sorted];
        uint places[most_sorted];
        count = 0;
        for (uint next = first; next != 0u; next = listed[next - 1u].next) {
            float depth = listed[next - 1u].depth;
            if (!is_nearer(last_depth, last_place, depth, next)) continue;
            if (count == most_sorted && !is_nearer(depth, next, depths[most_sorted - 1], places[most_sorted - 1])) continue;
            int to = count < most_sorted ? count++ : most_sorted - 1;
            for (; to > 0 && is_nearer(depth, next, depths[to - 1], places[to - 1]); --to) {
                depths[to] = depths[to - 1];
                places[to] = places[to - 1];
            }
            depths[to] = depth;
            places[to] = next;
        }

        // 2. Front to back, with the remaining transmittance.
        for (int i = 0; i < count; ++i) {
            ListedFragment f = listed[places[i] - 1u];
            vec2 blue_alpha = unpackHalf2x16(f.blue_alpha);
            sum += left * blue_alpha.y * vec3(unpackHalf2x16(f.red_green), blue_alpha.x);
            left = tint_through(left, blue_alpha.y, unpacked_tint(f.tint));
        }
        if (count > 0) {
            last_depth = depths[count - 1];
            last_place = places[count - 1];
        }
    }
    vec4 before = imageLoad(picture, at);
    imageStore(picture, at, vec4(sum + left * before.rgb, before.a));
}
