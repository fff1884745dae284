// What surfaces emit, added to what lights have made of them.
#include "04_surface_maps/surface_maps.glsl"

layout(location = 0) out vec4 color;
layout(scalar) uniform ViewBlock { CameraView view; };

void main() {
    MappedSurface m = map_surface(view.eye, materials[material_index], coordinates_at(view));
    if (is_cut_out(m.alpha, maps.cutoff)) discard;
    color = vec4(m.glow, 0.0);
}
