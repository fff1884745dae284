// Transmittance of a transparent caster, and its depth.
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out vec4 passed;
#ifndef FIRST
layout(location = 1) out float depth;
#endif

// Coloured transmittance, by convention: a surface absorbs all colours by its opacity, and increasingly those that its
// own colour lacks. Everything passes at opacity 0, nothing at 1.
void main() {
    MappedSurface m = seen_surface();
    passed = vec4((1.0 - m.alpha) * mix(vec3(1.0), m.substance.mixed.diffuse, m.alpha), 1.0);
#ifndef FIRST
    depth = gl_FragCoord.z;
#endif
}
