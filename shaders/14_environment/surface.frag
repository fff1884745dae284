// A surface with all its maps, lit by the scene's lights and by its surroundings. Car paint is a layer below a clear
// coat. For occlusion by rays, occluded.glsl replaces unoccluded.glsl.
#include "04_surface_maps/reflection.glsl"
#include "14_environment/leaving.glsl"
#include "common/put_surface.glsl"
#include "14_environment/unoccluded.glsl"

// [surface]
void main() {
    CoatedSurface c = coated_surface();
    Leaving light = leaving(c);
    c.m.substance.mixed.specular = c.f0;
    c.m.surface.shininess = shininess_of(c.m.surface.shininess, c.alpha);
    Lit lit = light_mapped(c.m, item, gl_FragCoord);
    light.body += c.albedo * lit.diffuse;
    light.coat += c.m.substance.mixed.specular * lit.specular;
#ifdef TRANSPARENT
    // Reflections cover the background; alpha lets the rest through.
    float n_dot_v = clamp(dot(c.m.surface.normal, c.m.surface.to_eye), 1e-3, 1.0);
    float covered = mix(max(c.f0.r, max(c.f0.g, c.f0.b)), 1.0, schlick_power(n_dot_v));
    float opacity = max(1.0 - (1.0 - c.m.alpha) * (1.0 - covered), 1e-3);
    put_surface(min((c.m.alpha * light.body + light.coat) / opacity, LARGEST_HALF), opacity);
#else
    put_surface(min(light.body + light.coat, LARGEST_HALF), 1.0);
#endif
}
// [/surface]
