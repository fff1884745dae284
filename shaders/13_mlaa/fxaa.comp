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
shared float kept[kept_size.x * kept_size.y];
shared uint strong[tile.x * tile.y], strong_count, changed_count;  // pixels with contrast

ivec2 corner() { return tile * ivec2(gl_WorkGroupID.xy); }
int slot_of(ivec2 place) { return (place.y + 1) * kept_size.x + place.x + 1; }
float kept_luma(ivec2 place) { return kept[slot_of(place)]; }
bool is_kept(ivec2 place) { return all(greaterThanEqual(place, ivec2(-1))) && all(lessThanEqual(place, tile)); }

// The pixels around the tile, by number.
const int ring_count = 2 * (kept_size.x + tile.y);
ivec2 ring_place(int i) {
    int beside = i - 2 * kept_size.x;
    if (i < kept_size.x) return ivec2(i - 1, -1);
    if (i < 2 * kept_size.x) return ivec2(i - kept_size.x - 1, tile.y);
    return ivec2((beside & 1) * (tile.x + 1) - 1, beside >> 1);
}

// The contrast of a pixel and its four neighbours, 0 where it is too low to be seen.
float contrast(float m, float n, float s, float w, float e) {
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
        int slot = slot_of(place + first * along), step = along.y * kept_size.x + along.x, aside = side.y * kept_size.x + side.x;
        for (int k = 0; k < asked; ++k) {
            near[k] = kept[slot + k * step];
            far[k] = kept[slot + k * step + aside];
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

// Writes the pixel's light, mixed with that of the neighbour across its edge. False where it takes nothing from it.
bool fxaa(ivec2 place) {
    vec4 texel = texelFetch(picture, corner() + place, 0);
    float m = kept_luma(place);
    float n = kept_luma(place + ivec2(0, -1)), s = kept_luma(place + ivec2(0, 1));
    float w = kept_luma(place + ivec2(-1, 0)), e = kept_luma(place + ivec2(1, 0));
    float nw = kept_luma(place + ivec2(-1, -1)), ne = kept_luma(place + ivec2(1, -1));
    float sw = kept_luma(place + ivec2(-1, 1)), se = kept_luma(place + ivec2(1, 1));
    float across_rows = abs(nw + sw - 2.0 * w) + 2.0 * abs(n + s - 2.0 * m) + abs(ne + se - 2.0 * e);
    float across_columns = abs(nw + ne - 2.0 * n) + 2.0 * abs(w + e - 2.0 * m) + abs(sw + se - 2.0 * s);
    // Where three blocks meet both are often equal: rounding, which is the device's, does not decide.
    bool horizontal = across_rows >= 0.99999 * across_columns;
    float before = horizontal ? n : w, behind = horizontal ? s : e;
    int towards = abs(before - m) >= abs(behind - m) ? -1 : 1;
    ivec2 side = horizontal ? ivec2(0, towards) : ivec2(towards, 0), along = horizontal ? ivec2(1, 0) : ivec2(0, 1);
    vec3 own = finite_light(texel.rgb), across = light_at(corner() + place + side);

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
    float lone = smoothstep(0.0, 1.0, clamp(abs(around - m) / contrast(m, n, s, w, e), 0.0, 1.0));
    float share = max(by_end, 0.5 * lone * lone);
    imageStore(into, corner() + place, share > 0.0 ? vec4(mix(own, across, share), texel.a) : texel);
    return share > 0.0;
}

// Few pixels have contrast. The workgroup's first threads take those, so that no thread waits while others search. All
// others are copied from registers.
void main() {
    int own = int(gl_LocalInvocationIndex);
    if (gl_GlobalInvocationID.xy == uvec2(0u)) next_work.groups[0] = next_work.listed_count = next_work.changed_count = 0u;
    if (own == 0) strong_count = changed_count = 0u;
    ivec2 size = textureSize(picture, 0), first = ivec2(gl_LocalInvocationID.xy) * ivec2(1, rows);
    vec4 texel[rows];
    for (int i = 0; i < rows; ++i) texel[i] = texelFetch(picture, min(corner() + first + ivec2(0, i), size - 1), 0);
    if (own < ring_count) kept[slot_of(ring_place(own))] = luma_of(light_at(corner() + ring_place(own)));
    float luma[rows];
    for (int i = 0; i < rows; ++i) kept[slot_of(first + ivec2(0, i))] = luma[i] = luma_of(finite_light(texel[i].rgb));
    barrier();

    float above = kept_luma(first - ivec2(0, 1)), below = kept_luma(first + ivec2(0, rows));
    uint found = 0u;  // a bit for each row
    for (int i = 0; i < rows; ++i) {
        ivec2 place = first + ivec2(0, i);
        float n = i > 0 ? luma[max(i - 1, 0)] : above, s = i < rows - 1 ? luma[min(i + 1, rows - 1)] : below;
        bool has_contrast = contrast(luma[i], n, s, kept_luma(place - ivec2(1, 0)), kept_luma(place + ivec2(1, 0))) > 0.0;
        bool inside = all(lessThan(corner() + place, size));
        if (inside && !has_contrast) imageStore(into, corner() + place, texel[i]);
        found |= uint(inside && has_contrast) << i;
    }
    if (found != 0u) {
        uint at = atomicAdd(strong_count, uint(bitCount(found)));
        for (int i = 0; i < rows; ++i)
            if ((found >> i & 1u) != 0u) strong[at++] = pack_pixel(first + ivec2(0, i));
    }
    barrier();
    if (strong_count == 0u) return;

    uint changed = 0u;
    for (uint at = uint(own); at < strong_count; at += uint(threads)) changed += uint(fxaa(unpack_pixel(strong[at])));
    if (changed > 0u) atomicAdd(changed_count, changed);
    barrier();
    if (own > 0) return;
    atomicAdd(work.listed_count, strong_count);
    atomicAdd(work.changed_count, changed_count);
}
