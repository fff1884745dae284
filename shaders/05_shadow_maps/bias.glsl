// How a point is lifted off its surface before the map is asked: so far that the surface's own depths, which the map has
// only in the middle of each texel, are not nearer to the light.
#include "05_shadow_maps/light_clip_position.glsl"
#include "05_shadow_maps/map_reads.glsl"
#include "05_shadow_maps/shadow_inputs.glsl"
#include "05_shadow_maps/slope_bias.glsl"

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
