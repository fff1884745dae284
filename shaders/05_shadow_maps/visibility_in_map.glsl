// What a light's map says of a point.
#include "05_shadow_maps/bias.glsl"
#include "05_shadow_maps/shadow_methods.glsl"
#include "05_shadow_maps/view_of.glsl"

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
