// Light of a coated surface from the scene's lights and from its surroundings.
#include "04_surface_maps/reflection.glsl"
#include "common/hash.glsl"
#include "14_environment/leaving.glsl"

Leaving lit_around(inout CoatedSurface c, vec4 frag_coord) {
#if MAPS_UNLIT
    return Leaving(vec3(0.0), c.m.glow);
#endif
#ifdef OCCLUDED
    // M. Roberts' sequence R2 over seeds: pictures of one pixel go on with each other's points.
    sample_shift = hash3(ivec3(frag_coord.xy, 0)).xy + float(view.seed) * vec2(0.7548777, 0.5698403);
#endif
    Leaving light = leaving(c);
    c.m.substance.mixed.specular = c.f0;
    Lit lit = light_mapped(c.m, item, frag_coord);
    light.body += c.albedo * lit.diffuse;
    light.coat += c.m.substance.mixed.specular * lit.specular;
#if !PAINT_COAT
    if (c.is_paint) light.coat = c.m.glow;
#endif
    return light;
}
