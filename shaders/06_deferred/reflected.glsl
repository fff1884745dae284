// Reflection of a decoded pixel: inputs of chapter 03's lights, and radiance from their sum.
#include "04_surface_maps/coat.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "06_deferred/pixel.glsl"

Surface surface_of(Pixel p, vec3 eye) {
    Surface surface = Surface(p.normal, normalize(eye - p.position), p.material.mixed.shininess, p.plane);
    coat_surface(surface, p.material.mixed.specular, p.material.mixed.diffuse,
                 p.material.ambient_specular > 0.0);
    return surface;
}

// Results of surface_of().
vec3 reflected(Pixel p, Lit lit) {
    return p.material.mixed.diffuse * lit.diffuse + specular_factor(p.material.mixed.specular) * lit.specular;
}

vec3 ambient_radiance(PixelMaterial m, vec3 ambient) {
    return (m.mixed.diffuse + ambient_of_coat(m.ambient_specular * m.mixed.specular)) * ambient * m.occlusion;
}
