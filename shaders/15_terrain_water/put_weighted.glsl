// Weighted, blended order-independent transparency: each surface's contribution to the sums. M. McGuire and L.
// Bavoil, "Weighted Blended Order-Independent Transparency", JCGT 2(2), 2013.
#include "15_terrain_water/tint.glsl"
#include "15_terrain_water/wboit_weight.glsl"

layout(location = 0) out vec4 weighted;  // added up
layout(location = 1) out vec4 behind;    // multiplied: the share of light that passes, by channel; 1 - alpha

void put_surface(vec3 radiance, float alpha, vec3 tint) {
    float weight =
        wboit_weight(TRANSPARENCY_WEIGHT, alpha, 1.0 / gl_FragCoord.w, 1.0 - gl_FragCoord.z);  // w: 1/m along the view
    weighted = vec4(radiance, 1.0) * alpha * weight;
    behind = vec4(tint_through(vec3(1.0), alpha, used_tint(tint)), 1.0 - alpha);
}
