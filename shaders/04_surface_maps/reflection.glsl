// How a surface with maps reflects lights: by Blinn and Phong's model, or by microfacets where its material states
// roughness.
#include "02_lambert_phong/blinn_phong_light.glsl"
#include "04_surface_maps/microfacets.glsl"
#include "04_surface_maps/surface_maps.glsl"

// Reflectance at normal incidence of the surface being lit.
vec3 lit_f0 = vec3(0.04);

Reflected reflect_light(Surface surface, vec3 to_light) {
#if SURFACE_GGX
    return reflect_by_ggx(surface, lit_f0, to_light);
#else
    return reflect_by_blinn_phong(surface, to_light);
#endif
}

// All lights on this surface. Afterwards mixed.specular is the remaining factor of their specular sum.
Lit light_mapped(inout MappedSurface m, uint drawn, vec4 fragment) {
#if SURFACE_GGX
    vec3 f0 = lit_f0 = m.substance.mixed.specular;
    float roughness = pow(2.0 / (m.surface.shininess + 2.0), 0.25);
    vec2 ab = reflected_from_everywhere(roughness, clamp(dot(m.surface.normal, m.surface.to_eye), 0.0, 1.0));
    vec3 everywhere = f0 * ab.x + ab.y;
    m.substance.ambient_specular = everywhere - everywhere * m.substance.mixed.diffuse;  // the body has the rest
    m.substance.mixed.specular = vec3(1.0);
#endif
#if MAPS_UNLIT
    return Lit(vec3(0.0), vec3(0.0), 0u);
#else
    return light_surface(m.surface, m.facing, m.position, drawn, fragment);
#endif
}
