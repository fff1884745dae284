// Visibility of lights: GLSL of the module Shadow, included instead of 03_attenuation/unshadowed.glsl. The method's
// filter is compiled in.
#include "03_attenuation/light_data.h"
#include "05_shadow_maps/shadow_data.h"
#include "05_shadow_maps/light_clip_position.glsl"
#include "05_shadow_maps/slope_bias.glsl"

layout(scalar) readonly buffer ShadowLightBuffer { ShadowLight shadow_lights[]; };
layout(scalar) readonly buffer ShadowViewBuffer { ShadowView shadow_views[]; };
layout(scalar) uniform ShadowEyeBlock { ShadowEye shadow_eye; };
layout(scalar) uniform ShadowBlock {
    float bias_m, slope, normal_offset;
    int kernel, taps, search_taps;
    float exponent, exponent_negative, min_variance, moment_bias, bleed;
} shadow;
uniform sampler2DArray shadow_moments;  // for methods with moments
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

// Light view that contains a point.
// Cube face of a direction: +x, -x, +y, -y, +z, -z.
uint cube_face(vec3 direction) {
    vec3 size = abs(direction);
    uint axis = size.x >= size.y && size.x >= size.z ? 0u : size.y >= size.z ? 1u : 2u;
    return 2u * axis + uint(direction[axis] < 0.0);
}

// [view_of]
// Finest cascade that contains the point and the filter's reach around it.
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

// Distance along the view, metres.
float map_distance(ShadowView view, float depth) {
    float d = view.to_distance.x + view.to_distance.y * depth;
    return view.perspective == 1u ? 1.0 / d : d;
}

// Linear depth: 0 at the near plane, 1 at the far plane.
float linear_depth(ShadowView view, float depth) {
    return clamp((map_distance(view, depth) - view.near) / (view.far - view.near), 0.0, 1.0);
}

// Bias: offset of the point so that the surface's own depths, stored only at texel centres, are not nearer to the
// light.
// Slope of depth over the map: a plane stays a plane in clip space, after division by w too.
vec2 plane_slope(ShadowView view, vec3 position, vec3 plane, float cosine) {
    vec4 clip_plane = view.plane_to_clip * vec4(plane, -dot(plane, position));
    if (abs(clip_plane.z) < 1e-20) return vec2(0.0);
    vec2 slope = -2.0 * clip_plane.xy / clip_plane.z;  // from -1..1 to 0..1
    return slope * min(cosine / 0.025, 1.0);  // bounded where the surface is parallel to the light
}

// Texel width at the point, metres.
float texel_at(ShadowView view, vec3 position) { return view.texel * abs((view.to_clip * vec4(position, 1.0)).w); }

// By how much faster the surface's depth may change beyond the triangle's edge. Interpolation tilts its normal by half the
// angle to the next triangle, which is therefore the mirror image of this one.
float slope_of_next(vec3 facing, vec3 plane, vec3 to_light) {
    vec3 next = reflect(-plane, facing);
    vec3 slope = next / max(dot(next, to_light), 0.025) - plane / max(dot(plane, to_light), 0.025);
    return length(slope - dot(slope, to_light) * to_light);
}

// `reach`: how far in texels a filter reads along u and along v.
Receiver receiver(ShadowView view, vec3 position, vec3 facing, vec3 plane, vec3 to_light, float reach) {
    float cosine = clamp(dot(plane, to_light), 0.0, 1.0);
    float texel = texel_at(view, position);
    // At 2^-19 of the depth range: some steps of the map's floats; a sixteenth of a texel, up to 16 times as much, since a
    // plane found from depths is slightly tilted.
    float depth_range = view.far - view.near;
    float least = shadow_eye.least_bias * max(depth_range, min(exp2(15.0) * texel, 16.0 * depth_range));
    float constant = max(min(shadow.bias_m, shadow_eye.bias_texels * texel), least);
    float towards = constant + shadow.slope * slope_bias(cosine, texel, reach);
#if SHADOW_RECEIVER_PLANE
    towards += min(slope_of_next(facing, plane, to_light), 1.0) * min(reach, 3.0) * texel;
#endif
    // Lifting a plane by h along its normal brings it h / cosine nearer to the light: of the tangent the sine is left.
    float along_normal = shadow.normal_offset * sqrt(2.0) * reach * texel * sqrt(1.0 - cosine * cosine);
    vec3 lifted = position + towards * to_light + along_normal * plane;
    Receiver r = Receiver(light_clip_position(view.to_clip, lifted), vec2(0.0));
#if SHADOW_RECEIVER_PLANE
    r.slope = plane_slope(view, position, plane, cosine);
#endif
    return r;
}

// Shadow filter: filter_reach() and filtered(). The module replaces this file with its method's.
#include "05_shadow_maps/filter_pcf.glsl"

// Visibility from a light's map.
// [visibility_in_map]
float visibility_in_map(ShadowLight light, vec3 position, vec3 facing, vec3 plane, vec3 to_light) {
    if (light.views == 0u) return 1.0;
    ShadowView view = shadow_views[view_of(light, position)];
    if (view.layer == NO_LAYER) return 1.0;
    if (dot(plane, to_light) <= 0.0) return 0.0;  // the triangle is its own shadow, though its normals face the light
    Receiver r = receiver(view, position, facing, plane, to_light, filter_reach(light, view, position));
    // Behind the light, beside its view, or beyond its reach.
    if (any(greaterThan(abs(r.place.xy - 0.5), vec2(0.5))) || r.place.z <= 0.0) return 1.0;
    float texel = texel_at(view, position), pixel = shadow_eye.pixel * length(shadow_eye.position - position);
    return filtered(light, view, r, texel, pixel);
}
// [/visibility_in_map]

#if SHADOW_TRANSPARENT == SHADOW_TRANSPARENT_COLORED
// Transmittance of transparent casters: product of all behind the last, the first one's between first and last.
// [passed_in_map]
vec3 passed_in_map(ShadowLight light, vec3 position, vec3 facing) {
    if (light.views == 0u) return vec3(1.0);
    ShadowView view = shadow_views[view_of(light, position)];
    if (view.layer == NO_LAYER) return vec3(1.0);
    // Bias over the four texels around the point: a transparent surface does not shadow itself.
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

#ifndef OWN_LIGHT_VISIBILITY
vec3 light_visibility(uint light, vec3 position, vec3 facing, vec3 plane, vec3 to_light) {
#if SHADOW_METHOD == SHADOW_METHOD_NONE
    return vec3(1.0);
#else
    ShadowLight maps = shadow_lights[light];
    // Lights without shadows: the edge of a large lamp may be above a surface that faces away from its centre.
    if (maps.views > 0u && dot(facing, to_light) <= 0.0) return vec3(0.0);
    vec3 visible = vec3(visibility_in_map(maps, position, facing, plane, to_light));
#if SHADOW_TRANSPARENT == SHADOW_TRANSPARENT_COLORED
    visible *= passed_in_map(maps, position, facing);
#endif
    return visible;
#endif
}
#endif
