// One pass by luma alone, after T. Lottes, "FXAA", 2009: the contrast around a pixel, the direction of its edge, how far
// the edge goes on to both sides, and how far the pixel lies from the nearer end.
#include "common/light.glsl"
#include "13_mlaa/list.glsl"
#include "13_mlaa/picture.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(scalar) uniform MlaaBlock { int search; } mlaa;
layout(rgba16f) writeonly uniform image2D mixed;

// As an eye takes it, about: the root of the luminance.
float luma_at(ivec2 pixel) { return sqrt(luminance(light_at(pixel))); }

// How many pixels from here the mean luma of the edge's two sides stays near that at the pixel; `left` is by how much it
// has changed where it does not.
int search_end(ivec2 pixel, ivec2 side, ivec2 along, float mean, float enough, out float left) {
    for (int i = 1; i <= mlaa.search; ++i) {
        left = 0.5 * (luma_at(pixel + i * along) + luma_at(pixel + i * along + side)) - mean;
        if (abs(left) >= enough) return i;
    }
    return mlaa.search;
}

// [fxaa]
// The share of the neighbour across the edge, and where that neighbour lies.
float fxaa_share(ivec2 pixel, out ivec2 side) {
    side = ivec2(0);
    float m = luma_at(pixel);
    float n = luma_at(pixel + ivec2(0, -1)), s = luma_at(pixel + ivec2(0, 1));
    float w = luma_at(pixel + ivec2(-1, 0)), e = luma_at(pixel + ivec2(1, 0));
    float most = max(max(max(n, s), max(w, e)), m), range = most - min(min(min(n, s), min(w, e)), m);
    if (range < max(1.0 / 16.0, most / 8.0)) return 0.0;

    float nw = luma_at(pixel + ivec2(-1, -1)), ne = luma_at(pixel + ivec2(1, -1));
    float sw = luma_at(pixel + ivec2(-1, 1)), se = luma_at(pixel + ivec2(1, 1));
    float across_rows = abs(nw + sw - 2.0 * w) + 2.0 * abs(n + s - 2.0 * m) + abs(ne + se - 2.0 * e);
    float across_columns = abs(nw + ne - 2.0 * n) + 2.0 * abs(w + e - 2.0 * m) + abs(sw + se - 2.0 * s);
    bool horizontal = across_rows >= across_columns;
    float before = horizontal ? n : w, behind = horizontal ? s : e;
    int towards = abs(before - m) >= abs(behind - m) ? -1 : 1;
    side = horizontal ? ivec2(0, towards) : ivec2(towards, 0);

    float other = towards < 0 ? before : behind, mean = 0.5 * (m + other), enough = 0.25 * abs(other - m);
    ivec2 along = horizontal ? ivec2(1, 0) : ivec2(0, 1);
    float left_back, left_ahead;
    int back = search_end(pixel, side, -along, mean, enough, left_back);
    int ahead = search_end(pixel, side, along, mean, enough, left_ahead);
    // The end that is nearer turns away from this pixel's side, or towards it: then there is nothing to take.
    float left = back < ahead ? left_back : left_ahead;
    bool turns_here = left * (m - mean) < 0.0 && abs(left) >= enough;
    float by_end = turns_here ? 0.5 - float(min(back, ahead) - 1) / float(back + ahead - 1) - 0.5 / float(back + ahead - 1) : 0.0;

    // What is smaller than a pixel: how far it stands out of its neighbours' mean.
    float around = (2.0 * (n + s + w + e) + nw + ne + sw + se) / 12.0;
    float lone = smoothstep(0.0, 1.0, clamp(abs(around - m) / range, 0.0, 1.0));
    return max(by_end, 0.5 * lone * lone);
}
// [/fxaa]

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), side = ivec2(0);
    bool inside = all(lessThan(pixel, textureSize(picture, 0)));
    float share = inside ? fxaa_share(pixel, side) : 0.0;
    put_on_list(share > 0.0, pixel);
    if (share > 0.0) imageStore(mixed, pixel, vec4(mix(light_at(pixel), light_at(pixel + side), share), 1.0));
    if (gl_LocalInvocationIndex == 0u && listed_here > 0u) atomicAdd(work.changed_count, listed_here);
}
