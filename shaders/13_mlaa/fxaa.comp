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

// Of a workgroup's square and the pixels around it, each read once.
const int square = 16, kept_side = square + 2;
shared float kept[kept_side * kept_side];
shared uint strong[square * square], strong_count;  // threads with contrast at their pixel

void keep_luma() {
    ivec2 from = square * ivec2(gl_WorkGroupID.xy) - 1;
    for (int slot = int(gl_LocalInvocationIndex); slot < kept_side * kept_side; slot += square * square)
        kept[slot] = luma_at(from + ivec2(slot % kept_side, slot / kept_side));
}
float kept_luma(ivec2 place) { return kept[(place.y + 1) * kept_side + place.x + 1]; }

// The contrast around a pixel of the square, 0 where it is too low to be seen.
float contrast(ivec2 place) {
    float m = kept_luma(place), n = kept_luma(place + ivec2(0, -1)), s = kept_luma(place + ivec2(0, 1));
    float w = kept_luma(place + ivec2(-1, 0)), e = kept_luma(place + ivec2(1, 0));
    float most = max(max(max(n, s), max(w, e)), m), range = most - min(min(min(n, s), min(w, e)), m);
    return range < max(1.0 / 16.0, most / 8.0) ? 0.0 : range;
}

// How many pixels from here the mean luma of the edge's two sides stays near that at the pixel; `left` is by how much it
// has changed where it does not.
int search_end(ivec2 pixel, ivec2 side, ivec2 along, float mean, float enough, out float left) {
    for (int i = 1; i <= mlaa.search; i += 2) {  // two at once: none of these reads waits for another
        ivec2 first = pixel + i * along, second = first + along;
        float change = 0.5 * (luma_at(first) + luma_at(first + side)) - mean, next_change = 0.5 * (luma_at(second) + luma_at(second + side)) - mean;
        left = change;
        if (abs(left) >= enough || i == mlaa.search) return i;
        left = next_change;
        if (abs(left) >= enough) return i + 1;
    }
    return mlaa.search;
}

// [fxaa]
// The share of the neighbour across the edge, and where that neighbour lies.
float fxaa_share(ivec2 place, out ivec2 side) {
    ivec2 pixel = square * ivec2(gl_WorkGroupID.xy) + place;
    float range = contrast(place), m = kept_luma(place);
    float n = kept_luma(place + ivec2(0, -1)), s = kept_luma(place + ivec2(0, 1));
    float w = kept_luma(place + ivec2(-1, 0)), e = kept_luma(place + ivec2(1, 0));
    float nw = kept_luma(place + ivec2(-1, -1)), ne = kept_luma(place + ivec2(1, -1));
    float sw = kept_luma(place + ivec2(-1, 1)), se = kept_luma(place + ivec2(1, 1));
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

    // Features smaller than a pixel: the difference from their neighbours' mean.
    float around = (2.0 * (n + s + w + e) + nw + ne + sw + se) / 12.0;
    float lone = smoothstep(0.0, 1.0, clamp(abs(around - m) / range, 0.0, 1.0));
    return max(by_end, 0.5 * lone * lone);
}
// [/fxaa]

// Few pixels have contrast. The workgroup's first threads take those, so that no thread waits while others search; a square
// without any is done.
void main() {
    begin_list();
    if (gl_LocalInvocationIndex == 0u) strong_count = 0u;
    keep_luma();
    barrier();
    ivec2 corner = square * ivec2(gl_WorkGroupID.xy), own = ivec2(gl_LocalInvocationID.xy);
    if (all(lessThan(corner + own, textureSize(picture, 0))) && contrast(own) > 0.0) strong[atomicAdd(strong_count, 1u)] = gl_LocalInvocationIndex;
    barrier();
    if (strong_count == 0u) return;
    ivec2 pixel = corner, side = ivec2(0);
    float share = 0.0;
    if (gl_LocalInvocationIndex < strong_count) {
        uint slot = strong[gl_LocalInvocationIndex];
        ivec2 place = ivec2(slot % square, slot / square);
        pixel += place;
        share = fxaa_share(place, side);
    }
    put_on_list(share > 0.0, pixel);
    if (share > 0.0) imageStore(mixed, pixel, vec4(mix(light_at(pixel), light_at(pixel + side), share), 1.0));
    if (gl_LocalInvocationIndex == 0u && listed_here > 0u) atomicAdd(work.changed_count, listed_here);
}
