// Transmittance of a transparent caster, and its depth.
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out vec4 passed;
#ifndef FIRST
layout(location = 1) out float depth;
#endif

// Coloured transmittance: a material's own, or by convention. A surface absorbs all colours by its opacity, and
// increasingly those that its own colour lacks. Everything passes at opacity 0, nothing at 1.
void main() {
    MappedSurface m = seen_surface();
    bool is_stated = materials[material_index].transmission.r >= 0.0;
    vec3 tint = is_stated ? m.tint : mix(vec3(1.0), m.substance.mixed.diffuse, m.alpha);
    passed = vec4((1.0 - m.alpha) * tint, 1.0);
#ifndef FIRST
    depth = gl_FragCoord.z;
#endif
}
