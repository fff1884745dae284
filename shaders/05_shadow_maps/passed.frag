// Transmittance of a transparent caster, and its depth.
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out vec4 passed;
#ifndef FIRST
layout(location = 1) out float depth;
#endif

// An opacity does not say which colours pass. Here a surface removes its opacity from all colours, and increasingly
// the colours that its own lacks: all passes at an opacity of 0, and nothing at 1.
void main() {
    MappedSurface m = seen_surface();
    passed = vec4((1.0 - m.alpha) * mix(vec3(1.0), m.substance.mixed.diffuse, m.alpha), 1.0);
#ifndef FIRST
    depth = gl_FragCoord.z;
#endif
}
