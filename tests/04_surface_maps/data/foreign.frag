// A chapter that is none of the course's: it has a METHOD and knobs of its own, beside the modules of 03 and 04.
#include "02_lambert_phong/reflection.glsl"
#include "03_attenuation/lighting.glsl"
#include "03_attenuation/unshadowed.glsl"
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out vec4 color;

layout(scalar) uniform KnobBlock {
    float strength;
    vec3 tint;
} knobs;

void main() {
    MappedSurface m = map_surface(view.eye, materials[material_index], coordinates_at(view));
    Lit lit = light_surface(m.surface, m.facing, m.position, item, gl_FragCoord);
#if METHOD == METHOD_BRIGHT
    color = vec4(knobs.strength * lit.diffuse, 1.0);
#else
    color = vec4(knobs.tint * lit.specular + m.glow, m.alpha);
#endif
}
