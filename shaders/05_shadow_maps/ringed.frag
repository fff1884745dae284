// Planet with a transparent ring, which shadow each other analytically.
#include "04_surface_maps/reflection.glsl"
#include "05_shadow_maps/planet_shadow.glsl"
#include "common/put_surface.glsl"

vec3 light_visibility(uint light, vec3 position, vec3 facing, vec3 plane, vec3 to_light) {
    return vec3(planet_visibility(position, to_light));
}

void main() {
    MappedSurface m = seen_surface();
    Lit lit = light_mapped(m, item, gl_FragCoord);
    put_surface(radiance_of(m, lit.diffuse, lit.specular, ambient), m.alpha, m.tint);
}
