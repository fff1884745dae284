// What of a light arrives behind what stands in its way: what the module Shadow gives to shaders. Whoever lights by
// 03_attenuation/lighting.glsl includes it instead of 03_attenuation/unshadowed.glsl. Of the methods one is compiled in.
#include "03_attenuation/light_data.h"
#include "05_shadow_maps/shadow_data.h"
#include "05_shadow_maps/light_clip_position.glsl"
#include "05_shadow_maps/slope_bias.glsl"
#include "05_shadow_maps/compare_depth.glsl"
#include "05_shadow_maps/pcf.glsl"
#include "05_shadow_maps/penumbra_width.glsl"
#include "05_shadow_maps/chebyshev.glsl"

layout(scalar) readonly buffer ShadowLightBuffer { ShadowLight shadow_lights[]; };
layout(scalar) readonly buffer ShadowViewBuffer { ShadowView shadow_views[]; };
layout(scalar) uniform ShadowEyeBlock { ShadowEye shadow_eye; };
layout(scalar) uniform ShadowBlock {
    float bias_m, slope, normal_offset;
    int kernel, taps, search_taps;
    float exponent, exponent_negative, min_variance, moment_bias, bleed;
} shadow;
uniform sampler2DArray shadow_moments;  // where the method has any
uniform sampler2DArray shadow_map;
#if SHADOW_TRANSPARENT == SHADOW_TRANSPARENT_COLORED
uniform sampler2DArray shadow_first;
uniform sampler2DArray shadow_first_depth;
uniform sampler2DArray shadow_passed;
uniform sampler2DArray shadow_last_depth;
#endif

int map_texels() { return textureSize(shadow_map, 0).x; }
float read_depth(vec2 uv, uint layer) { return textureLod(shadow_map, vec3(uv, layer), 0.0).r; }
vec4 gather_depths(vec2 uv, uint layer) { return textureGather(shadow_map, vec3(uv, layer), 0); }

// Which of a light's views sees a point.
// [cube_face]
// The face of a cube through which a direction leaves it: +x, -x, +y, -y, +z, -z.
uint cube_face(vec3 direction) {
    vec3 size = abs(direction);
    uint axis = size.x >= size.y && size.x >= size.z ? 0u : size.y >= size.z ? 1u : 2u;
    return 2u * axis + uint(direction[axis] < 0.0);
}
// [/cube_face]

// [view_of]
// Of cascades the finest that holds the point and around it all that a filter may read.
uint view_of(ShadowLight light, vec3 position) {
    if (light.kind == LIGHT_POINT) return light.first_view + cube_face(position - light.position);
    uint last = light.first_view + light.views - 1u;
    for (uint view = light.first_view; view < last; ++view) {
        vec2 place = light_clip_position(shadow_views[view].to_clip, position).xy;
        if (all(lessThanEqual(abs(place - 0.5), vec2(0.5 - MAP_MARGIN)))) return view;
    }
    return last;
}
// [/view_of]

// [map_distance]
// Metres along the view.
float map_distance(ShadowView view, float depth) {
    float d = view.to_distance.x + view.to_distance.y * depth;
    return view.perspective == 1u ? 1.0 / d : d;
}

// 0 at the near plane, 1 at the far one, in proportion to the distance.
float linear_depth(ShadowView view, float depth) {
    return clamp((map_distance(view, depth) - view.near) / (view.far - view.near), 0.0, 1.0);
}
// [/map_distance]

// How a point is lifted off its surface before the map is asked: so far that the surface's own depths, which the map has
// only in the middle of each texel, are not nearer to the light.
// [plane_slope]
// In clip space a plane is a plane again, after the division by w too: depth changes evenly over the map.
vec2 plane_slope(ShadowView view, vec3 position, vec3 facing, float cosine) {
    vec4 plane = view.plane_to_clip * vec4(facing, -dot(facing, position));
    if (abs(plane.z) < 1e-20) return vec2(0.0);
    vec2 slope = -2.0 * plane.xy / plane.z;  // x and y go from -1 to 1, u and v from 0 to 1
    return slope * min(cosine / 0.025, 1.0);  // a plane along the light's way has no end of slope
}
// [/plane_slope]

// The width of a texel of the map where the point is, in metres.
float texel_at(ShadowView view, vec3 position) { return view.texel * abs((view.to_clip * vec4(position, 1.0)).w); }

// [receiver]
// `reach`: how far in texels a filter reads along u and along v.
Receiver receiver(ShadowView view, vec3 position, vec3 facing, vec3 to_light, float reach) {
    float cosine = clamp(dot(facing, to_light), 0.0, 1.0);
    float texel = texel_at(view, position);
    float towards = shadow.bias_m + shadow.slope * slope_bias(cosine, texel, reach);
    // Lifting a plane by h along its normal brings it h / cosine nearer to the light: of the tangent the sine is left.
    float along_normal = shadow.normal_offset * sqrt(2.0) * reach * texel * sqrt(1.0 - cosine * cosine);
    vec3 lifted = position + towards * to_light + along_normal * facing;
    Receiver r = Receiver(light_clip_position(view.to_clip, lifted), vec2(0.0));
#if SHADOW_RECEIVER_PLANE
    r.slope = plane_slope(view, position, facing, cosine);
#endif
    return r;
}
// [/receiver]

// [pcf_single]
// The same result as pcf(), a texel at a time.
float pcf_single(Receiver r, uint layer, int kernel) {
    float texels = float(map_texels());
    vec2 begin = r.place.xy * texels - 0.5 * float(kernel), first = floor(begin), part = begin - first;
    float sum = 0.0;
    for (int y = 0; y <= kernel; ++y) {
        float row = y == 0 ? 1.0 - part.y : y == kernel ? part.y : 1.0;
        for (int x = 0; x <= kernel; ++x) {
            float column = x == 0 ? 1.0 - part.x : x == kernel ? part.x : 1.0;
            vec2 middle = (first + vec2(x, y) + 0.5) / texels;
            sum += row * column * float(plane_depth(r, middle) >= read_depth(middle, layer));
        }
    }
    return sum / float(kernel * kernel);
}
// [/pcf_single]

// What a texel of a moment map holds of a depth, and what is read from it. Depth: 0 at the near plane, 1 at the far one.
// [warp]
// Exponential variance shadows (A. Lauritzen and M. McCool, "Layered Variance Shadow Maps", GI 2008): e^cz pushes what is
// in front of the receiver together, -e^-cz what is behind. The square of e^c must fit the format: ln(3.4e38) / 2 is
// 44.3, ln(65504) / 2 is 5.54; sums of a blur take a little more.
float exponent_cap() {
#if SHADOW_FORMAT == SHADOW_FORMAT_FP16
    return 5.54;
#else
    return 42.0;
#endif
}
vec2 warp(float depth, float exponent, float exponent_negative) {
    float z = 2.0 * depth - 1.0;
    return vec2(exp(min(exponent, exponent_cap()) * z), -exp(-min(exponent_negative, exponent_cap()) * z));
}
// [/warp]

// [moments_of]
vec4 moments_of(float depth, float exponent, float exponent_negative) {
#if SHADOW_METHOD == SHADOW_METHOD_EVSM
    vec2 w = warp(depth, exponent, exponent_negative);
    return vec4(w, w * w);
#else
    float square = depth * depth;
    return vec4(depth, square, square * depth, square * square);
#endif
}
// [/moments_of]

// [evsm]
float evsm(vec4 moments, float depth, float exponent, float exponent_negative, float least) {
    vec2 w = warp(depth, exponent, exponent_negative);
    // The slope of the warp there: a variance of `least` in depth is as much in it.
    vec2 scale = 2.0 * vec2(min(exponent, exponent_cap()), min(exponent_negative, exponent_cap())) * w;
    vec2 smallest = max(least * scale * scale, 1e-30);
    return min(chebyshev(moments.xz, w.x, smallest.x), chebyshev(moments.yw, w.y, smallest.y));
}
// [/evsm]

// [msm]
// C. Peters and R. Klein, "Moment Shadow Mapping", I3D 2015: of all distributions of depth with these four moments, that
// which has the least of it in front of the receiver has it at three depths, the receiver's being one. The two others are
// the roots of a quadratic whose coefficients c solve B c = (1, z, z²), B the moments' Hankel matrix.
float msm(vec4 moments, float z, float bias) {
    vec4 b = mix(moments, vec4(0.5), bias);  // so that B can be inverted in spite of rounding
    // B = L D Lᵀ with ones on L's diagonal; its first column is (1, b.x, b.y).
    float d2 = max(b.y - b.x * b.x, 1e-12), l32 = (b.z - b.x * b.y) / d2;
    float d3 = max(b.w - b.y * b.y - l32 * l32 * d2, 1e-12);
    float y2 = z - b.x, y3 = z * z - b.y - l32 * y2;
    float c3 = y3 / d3, c2 = y2 / d2 - l32 * c3, c1 = 1.0 - b.x * c2 - b.y * c3;
    float most = max(abs(c3), 1e-12) * (c3 < 0.0 ? -1.0 : 1.0);
    float half_p = -0.5 * c2 / most, root = sqrt(max(half_p * half_p - c1 / most, 0.0));
    float z1 = half_p - root, z2 = half_p + root;
    if (z <= z1) return 1.0;
    // The weights of what is in front: the other two depths and their moments say them.
    float a = z <= z2 ? z : z1, in_front = z <= z2 ? 0.0 : 1.0, other = z <= z2 ? z1 : z;
    float apart = (z2 - other) * (z - z1);
    if (abs(apart) < 1e-20) return 1.0 - in_front;
    float share = (a * z2 - b.x * (a + z2) + b.y) / apart;
    return clamp(1.0 - (in_front + share), 0.0, 1.0);
}
// [/msm]

// Percentage-closer soft shadows: look for what is in the way, estimate how soft its edge is, and filter as wide.
// [disc]
// Points evenly spread over a disc of radius 1 (H. Vogel, "A Better Way to Construct the Sunflower Head", 1979).
vec2 disc_point(int i, int count, float turn) {
    float angle = 2.39996323 * float(i) + turn;
    return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}

// Each quarter of a texel turns its disc otherwise: noise is less of an eyesore than rings. Whole numbers, so that the
// last bits of uv, which differ between devices, do not choose.
float disc_turn(vec2 uv) {
    uvec2 cell = uvec2(max(4.0 * float(map_texels()) * uv, 0.0));
    uint hash = (cell.x * 0x9e3779b9u) ^ (cell.y * 0x85ebca6bu);
    hash = (hash ^ (hash >> 15)) * 0x2c1b3c6du;
    return 6.2831853 * float(hash >> 8) / 16777216.0;
}
// [/disc]

// How many times its own width the map is wide at the point, per metre.
float map_widths_per_metre(ShadowView view, float distance) {
    return 1.0 / (view.texel * float(map_texels()) * (view.perspective == 1u ? distance : 1.0));
}

// Along the view; of a directional light from the near plane.
float lamp_distance(ShadowView view, float depth) {
    return map_distance(view, depth) - (view.perspective == 1u ? 0.0 : view.near);
}

// [find_blockers]
// How far from the lamp, or from the near plane of a directional light, what lies within `radius` (in widths of the map)
// in front of the surface is in the mean; below 0: nothing does.
float mean_blocker(ShadowView view, Receiver r, float radius, float turn) {
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < shadow.search_taps; ++i) {
        vec2 uv = r.place.xy + radius * disc_point(i, shadow.search_taps, turn);
        uv = (floor(uv * float(map_texels())) + 0.5) / float(map_texels());  // where the texel's depth is right
        float stored = read_depth(uv, view.layer);
        if (stored <= plane_depth(r, uv)) continue;
        sum += lamp_distance(view, stored);
        count += 1.0;
    }
    return count > 0.0 ? sum / count : -1.0;
}
// [/find_blockers]

// The four texels around uv, weighted by how near they are.
float lit_between(Receiver r, uint layer, vec2 uv) {
    float texels = float(map_texels());
    vec2 corner = floor(uv * texels - 0.5) + 1.0, part = uv * texels - corner + 0.5;
    vec4 lit = vec4(greaterThanEqual(plane_depths(r, corner / texels), gather_depths(corner / texels, layer)));
    vec2 columns = vec2(1.0 - part.x, part.x);
    return dot(lit, vec4(columns, columns.yx) * vec4(part.yy, 1.0 - part.yy));
}

// How far to look: what is right at the map's near plane could be in the way. `distance` as lamp_distance().
float search_radius(ShadowLight light, ShadowView view, float distance) {
    bool parallel = view.perspective == 0u;
    float widest = penumbra_width(distance, parallel ? 0.0 : view.near, light.size, parallel);
    return clamp(0.5 * widest * map_widths_per_metre(view, distance), 0.0, MAP_MARGIN);
}

// [pcss]
float pcss(ShadowLight light, ShadowView view, Receiver r) {
    float receiver = lamp_distance(view, r.place.z), texel = 1.0 / float(map_texels()), turn = disc_turn(r.place.xy);
    float blocker = mean_blocker(view, r, max(search_radius(light, view, receiver), texel), turn);
    if (blocker < 0.0) return 1.0;
    float width = penumbra_width(receiver, blocker, light.size, view.perspective == 0u);
    float radius = clamp(0.5 * width * map_widths_per_metre(view, receiver), 0.5 * texel, MAP_MARGIN);
    float sum = 0.0;
    for (int i = 0; i < shadow.taps; ++i)
        sum += lit_between(r, view.layer, r.place.xy + radius * disc_point(i, shadow.taps, turn));
    return sum / float(shadow.taps);
}
// [/pcss]

// [filter_reach]
// How far in texels along u and along v the method asks the map: what the bias has to reckon with.
float filter_reach(ShadowLight light, ShadowView view, vec3 position) {
#if SHADOW_METHOD == SHADOW_METHOD_PCF
    return 0.5 * float(shadow.kernel) + 0.5;
#elif SHADOW_METHOD == SHADOW_METHOD_PCSS
    float distance = lamp_distance(view, max(light_clip_position(view.to_clip, position).z, 0.0));
    return 1.0 + float(map_texels()) * search_radius(light, view, distance);
#else
    return 0.5;
#endif
}
// [/filter_reach]

// [hard]
float hard(Receiver r, uint layer) {
    // The texel's depth is right in its middle: there the surface's own is compared.
    vec2 middle = (floor(r.place.xy * float(map_texels())) + 0.5) / float(map_texels());
    vec3 place = vec3(r.place.xy, plane_depth(r, middle));
    return compare_depth(place, read_depth(r.place.xy, layer));
}
// [/hard]

// [from_moments]
// From a mip whose texels are about as wide as the pixel is on the surface. `texel`: of the first one, in metres.
float from_moments(ShadowView view, Receiver r, float texel, float pixel) {
#if SHADOW_MIPS
    float lod = max(log2(max(pixel, 1e-9) / texel), 0.0);
#else
    float lod = 0.0;
#endif
    vec4 moments = textureLod(shadow_moments, vec3(r.place.xy, view.layer), lod);
    float depth = linear_depth(view, r.place.z);
#if SHADOW_METHOD == SHADOW_METHOD_VSM
    float visible = chebyshev(moments.xy, depth, shadow.min_variance);
#elif SHADOW_METHOD == SHADOW_METHOD_EVSM
    float visible = evsm(moments, depth, shadow.exponent, shadow.exponent_negative, shadow.min_variance);
#else
    float visible = msm(moments, depth, shadow.moment_bias);
#endif
    return clamp((visible - shadow.bleed) / (1.0 - shadow.bleed), 0.0, 1.0);  // less of what leaks, and of penumbrae
}
// [/from_moments]

// [filtered]
float filtered(ShadowLight light, ShadowView view, Receiver r, float texel, float pixel) {
#if SHADOW_METHOD == SHADOW_METHOD_HARD
    return hard(r, view.layer);
#elif SHADOW_METHOD == SHADOW_METHOD_PCF && SHADOW_FETCH == SHADOW_FETCH_SINGLE
    return pcf_single(r, view.layer, shadow.kernel | 1);
#elif SHADOW_METHOD == SHADOW_METHOD_PCF
    return pcf(r, view.layer, shadow.kernel | 1);
#elif SHADOW_METHOD == SHADOW_METHOD_PCSS
    return pcss(light, view, r);
#else
    return from_moments(view, r, texel, pixel);
#endif
}
// [/filtered]

// What a light's map says of a point.
// [visibility_in_map]
float visibility_in_map(ShadowLight light, vec3 position, vec3 facing, vec3 to_light) {
    if (light.views == 0u) return 1.0;
    ShadowView view = shadow_views[view_of(light, position)];
    if (view.layer == NO_LAYER) return 1.0;
    Receiver r = receiver(view, position, facing, to_light, filter_reach(light, view, position));
    // Behind the light, beside its view, or beyond what it reaches.
    if (any(greaterThan(abs(r.place.xy - 0.5), vec2(0.5))) || r.place.z <= 0.0) return 1.0;
    float texel = texel_at(view, position), pixel = shadow_eye.pixel * length(shadow_eye.position - position);
    return filtered(light, view, r, texel, pixel);
}
// [/visibility_in_map]

#if SHADOW_TRANSPARENT == SHADOW_TRANSPARENT_COLORED
// What transparent casters let through of a light: behind the last the product of all, between first and last the first's.
// [passed_in_map]
vec3 passed_in_map(ShadowLight light, vec3 position, vec3 facing) {
    if (light.views == 0u) return vec3(1.0);
    ShadowView view = shadow_views[view_of(light, position)];
    if (view.layer == NO_LAYER) return vec3(1.0);
    // A transparent surface is not in its own shadow: four texels meet in the place that is asked for.
    vec3 before = position + 2.0 * texel_at(view, position) * facing;
    vec3 place = light_clip_position(view.to_clip, before);
    if (any(greaterThan(abs(place.xy - 0.5), vec2(0.5))) || place.z <= 0.0) return vec3(1.0);
    vec3 texel = vec3(place.xy, view.layer);
    vec4 last = textureGather(shadow_last_depth, texel, 0);
    if (place.z < min(min(last.x, last.y), min(last.z, last.w))) return textureLod(shadow_passed, texel, 0.0).rgb;
    vec4 first = textureGather(shadow_first_depth, texel, 0);
    bool is_behind = place.z < max(max(first.x, first.y), max(first.z, first.w));
    return is_behind ? textureLod(shadow_first, texel, 0.0).rgb : vec3(1.0);
}
// [/passed_in_map]
#endif

// [light_visibility]
#ifndef OWN_LIGHT_VISIBILITY
vec3 light_visibility(uint light, vec3 position, vec3 facing, vec3 to_light) {
#if SHADOW_METHOD == SHADOW_METHOD_NONE
    return vec3(1.0);
#else
    // What faces away is dark by itself, and no map is asked.
    if (dot(facing, to_light) <= 0.0) return vec3(0.0);
    vec3 visible = vec3(visibility_in_map(shadow_lights[light], position, facing, to_light));
#if SHADOW_TRANSPARENT == SHADOW_TRANSPARENT_COLORED
    visible *= passed_in_map(shadow_lights[light], position, facing);
#endif
    return visible;
#endif
}
#endif
// [/light_visibility]
