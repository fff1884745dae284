// Light of a coated surface from the scene's lights and from its surroundings.
#include "04_surface_maps/reflection.glsl"
#include "14_environment/leaving.glsl"

Leaving lit_around(inout CoatedSurface c, vec4 frag_coord) {
    Leaving light = leaving(c);
    c.m.substance.mixed.specular = c.f0;
    c.m.surface.shininess = shininess_of(c.m.surface.shininess, c.alpha);
    Lit lit = light_mapped(c.m, item, frag_coord);
    light.body += c.albedo * lit.diffuse;
    light.coat += c.m.substance.mixed.specular * lit.specular;
    return light;
}
