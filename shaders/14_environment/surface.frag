// A surface with all its maps, lit by the scene's lights and by its surroundings. Car paint is a layer below a clear
// coat. For occlusion by rays, occluded.glsl replaces unoccluded.glsl.
#include "14_environment/lit_around.glsl"
#include "common/put_surface.glsl"
#include "14_environment/unoccluded.glsl"

void main() {
    CoatedSurface c = coated_surface();
    Leaving light = lit_around(c, gl_FragCoord);
#ifdef TRANSPARENT
    // Alpha is coverage: where it is 0, nothing is there. Glass is there, reflects all over, and alpha is its body's.
    if (substances[item].glass == 0u) {
        put_surface(min(light.body + light.coat, LARGEST_HALF), c.m.alpha, c.m.tint);
        return;
    }
    float n_dot_v = clamp(dot(c.m.surface.normal, c.m.surface.to_eye), 1e-3, 1.0);
    float covered = mix(max(c.f0.r, max(c.f0.g, c.f0.b)), 1.0, schlick_power(n_dot_v));
    float opacity = max(1.0 - (1.0 - c.m.alpha) * (1.0 - covered), 1e-3);
    put_surface(min((c.m.alpha * light.body + light.coat) / opacity, LARGEST_HALF), opacity, c.m.tint);
#else
    put_surface(min(light.body + light.coat, LARGEST_HALF), 1.0, vec3(1.0));
#endif
}
