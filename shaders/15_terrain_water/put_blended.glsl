// Transparent surfaces blended in the order in which they are drawn.
#include "15_terrain_water/tint.glsl"

layout(location = 0) out vec4 color;
layout(location = 0, index = 1) out vec4 passed;  // share of the light behind, by channel: Blend::filtered

void put_surface(vec3 radiance, float alpha, vec3 tint) {
    color = vec4(radiance, alpha);
    passed = vec4(tint_through(vec3(1.0), alpha, used_tint(tint)), 0.0);
}
