// One pass by luma alone, after T. Lottes, "FXAA", 2009: the contrast around a pixel, the direction of its edge, how far
// the edge goes on to both sides, and how far the pixel lies from the nearer end.
#include "common/light.glsl"
#include "13_mlaa/picture.glsl"
#include "13_mlaa/work.glsl"

layout(local_size_x = 32, local_size_y = 8) in;

layout(scalar) uniform MlaaBlock { int search; } mlaa;
layout(scalar) writeonly buffer NextWorkBuffer { Work next_work; };  // of the next frame
layout(rgba16f) writeonly uniform image2D into;

// As an eye takes it, about: the root of the luminance.
float luma_of(vec3 light) { return sqrt(luminance(light)); }

// Of a workgroup's tile and the pixels around it, each read once; a thread has four pixels of a column.
const int rows = 4, threads = int(gl_WorkGroupSize.x * gl_WorkGroupSize.y);
const ivec2 tile = ivec2(gl_WorkGroupSize.x, rows * gl_WorkGroupSize.y), kept_size = tile + 2;
const int kept_count = kept_size.x * kept_size.y, rounds = (kept_count + threads - 1) / threads;
shared float kept[kept_count];
shared uint strong[tile.x * tile.y], strong_count, changed_count;  // pixels with contrast

ivec2 corner() { return tile * ivec2(gl_WorkGroupID.xy); }

// All reads of a thread first: none waits for another.
void keep_luma() {
    vec3 light[rounds];
    for (int k = 0; k < rounds; ++k) {
        int slot = int(gl_LocalInvocationIndex) + k * threads;
        light[k] = light_at(corner() - 1 + ivec2(slot % kept_size.x, slot / kept_size.x));
    }
    for (int k = 0; k < rounds; ++k) {
        int slot = int(gl_LocalInvocationIndex) + k * threads;
        if (slot < kept_count) kept[slot] = luma_of(light[k]);
    }
}
float kept_luma(ivec2 place) { return kept[(place.y + 1) * kept_size.x + place.x + 1]; }
bool is_kept(ivec2 place) { return all(greaterThanEqual(place, ivec2(-1))) && all(lessThanEqual(place, tile)); }

// The contrast around a pixel of the tile, 0 where it is too low to be seen.
float contrast(ivec2 place) {
    float m = kept_luma(place), n = kept_luma(place + ivec2(0, -1)), s = kept_luma(place + ivec2(0, 1));
    float w = kept_luma(place + ivec2(-1, 0)), e = kept_luma(place + ivec2(1, 0));
    float most = max(max(max(n, s), max(w, e)), m), range = most - min(min(min(n, s), min(w, e)), m);
    return range < max(1.0 / 16.0, most / 8.0) ? 0.0 : range;
}

// How many pixels from here the mean luma of the edge's two sides stays near that at the pixel; `left` is by how much it
// has changed where it does not.
struct End {
    int steps;  // 0: not found yet
    float left;
};

// The next pixels from step `first` on: none of their reads waits for another.
const int asked = 4;
void search_on(inout End end, int first, ivec2 place, ivec2 side, ivec2 along, float mean, float enough) {
    if (end.steps > 0) return;
    float near[asked], far[asked];
    if (is_kept(place + (first + asked - 1) * along)) {
        for (int k = 0; k < asked; ++k) {
            ivec2 at = place + (first + k) * along;
            near[k] = kept_luma(at);
            far[k] = kept_luma(at + side);
        }
    } else {
        vec3 light[asked], other[asked];
        for (int k = 0; k < asked; ++k) {
            ivec2 at = corner() + place + (first + k) * along;
            light[k] = light_at(at);
            other[k] = light_at(at + side);
        }
        for (int k = 0; k < asked; ++k) {
            near[k] = luma_of(light[k]);
            far[k] = luma_of(other[k]);
        }
    }
    for (int k = 0; k < asked; ++k)
        if (end.steps == 0) {
            end.left = 0.5 * (near[k] + far[k]) - mean;
            if (abs(end.left) >= enough || first + k == mlaa.search) end.steps = first + k;
        }
}

// [fxaa]
// The pixel's light, mixed with that of the neighbour across its edge; alpha is the share of that neighbour.
vec4 fxaa(ivec2 place) {
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
    ivec2 side = horizontal ? ivec2(0, towards) : ivec2(towards, 0), along = horizontal ? ivec2(1, 0) : ivec2(0, 1);
    vec3 own = light_at(corner() + place), across = light_at(corner() + place + side);

    float other = towards < 0 ? before : behind, mean = 0.5 * (m + other), enough = 0.25 * abs(other - m);
    End back = End(0, 0.0), ahead = End(0, 0.0);
    for (int first = 1; first <= mlaa.search && (back.steps == 0 || ahead.steps == 0); first += asked) {
        search_on(back, first, place, side, -along, mean, enough);
        search_on(ahead, first, place, side, along, mean, enough);
    }
    // The end that is nearer turns away from this pixel's side, or towards it: then there is nothing to take.
    float left = back.steps < ahead.steps ? back.left : ahead.left, length = float(back.steps + ahead.steps - 1);
    bool turns_here = left * (m - mean) < 0.0 && abs(left) >= enough;
    float by_end = turns_here ? 0.5 - float(min(back.steps, ahead.steps) - 1) / length - 0.5 / length : 0.0;

    // Features smaller than a pixel: the difference from their neighbours' mean.
    float around = (2.0 * (n + s + w + e) + nw + ne + sw + se) / 12.0;
    float lone = smoothstep(0.0, 1.0, clamp(abs(around - m) / range, 0.0, 1.0));
    float share = max(by_end, 0.5 * lone * lone);
    return vec4(mix(own, across, share), share);
}
// [/fxaa]

// Few pixels have contrast. The workgroup's first threads take those, so that no thread waits while others search. All
// others are copied.
void main() {
    uint own = gl_LocalInvocationIndex;
    if (gl_GlobalInvocationID.xy == uvec2(0u)) next_work.groups[0] = next_work.listed_count = next_work.changed_count = 0u;
    if (own == 0u) strong_count = changed_count = 0u;
    keep_luma();
    barrier();
    ivec2 size = textureSize(picture, 0), first = ivec2(gl_LocalInvocationID.xy) * ivec2(1, rows);
    vec4 texel[rows];
    for (int i = 0; i < rows; ++i) texel[i] = texelFetch(picture, min(corner() + first + ivec2(0, i), size - 1), 0);
    for (int i = 0; i < rows; ++i) {
        ivec2 place = first + ivec2(0, i);
        if (any(greaterThanEqual(corner() + place, size))) continue;
        if (contrast(place) > 0.0) strong[atomicAdd(strong_count, 1u)] = pack_pixel(place);
        else imageStore(into, corner() + place, texel[i]);
    }
    barrier();
    if (strong_count == 0u) return;
    for (uint at = own; at < strong_count; at += uint(threads)) {
        ivec2 place = unpack_pixel(strong[at]), pixel = corner() + place;
        vec4 found = fxaa(place), before = texelFetch(picture, pixel, 0);
        imageStore(into, pixel, found.a > 0.0 ? vec4(found.rgb, before.a) : before);
        if (found.a > 0.0) atomicAdd(changed_count, 1u);
    }
    barrier();
    if (own > 0u) return;
    atomicAdd(work.listed_count, strong_count);
    atomicAdd(work.changed_count, changed_count);
}
