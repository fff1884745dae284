// visible.frag for surfaces with holes cut by textures.
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out uvec2 visible;

void main() {
    seen_surface();
    visible = uvec2(item + 1u, uint(gl_PrimitiveID));
}
