// A planet and its ring, which shadow each other without a map; what lies behind the ring shows through.
#include "05_shadow_maps/lit_fragment.glsl"
#include "05_shadow_maps/planet_shadow.glsl"

// [light_visibility]
float light_visibility(uint light, vec3 position, vec3 facing, vec3 to_light) {
    return planet_visibility(position, to_light);
}
// [/light_visibility]

void main() {
    MappedSurface m;
    vec3 radiance = lit_fragment(m);
    color = vec4(radiance, m.alpha);
}
