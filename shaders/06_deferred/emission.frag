// Emission, to which light is added.
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out vec4 color;

void main() {
    MappedSurface m = seen_surface();
    color = vec4(m.glow, 0.0);
}
