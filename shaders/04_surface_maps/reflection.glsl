// Reflection of lights by a mapped surface: Blinn–Phong, or microfacets for materials with roughness.
#include "04_surface_maps/coat.glsl"
#include "04_surface_maps/surface_maps.glsl"

// Sum over lights; mixed.specular becomes the remaining factor of the specular sum.
Lit light_mapped(inout MappedSurface m, uint drawn, vec4 fragment) {
    coat_surface(m.surface, m.substance.mixed.specular, m.substance.mixed.diffuse,
                 m.substance.ambient_specular != vec3(0.0));
    m.substance.ambient_specular = ambient_of_coat(m.substance.ambient_specular);
    m.substance.mixed.specular = specular_factor(m.substance.mixed.specular);
#if MAPS_UNLIT
    return Lit(vec3(0.0), vec3(0.0), 0u);
#else
    return light_surface(m.surface, m.facing, m.position, drawn, fragment);
#endif
}
