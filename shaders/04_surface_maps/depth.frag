// Depth alone: what is cut out leaves none.
#include "04_surface_maps/surface_maps.glsl"

layout(scalar) uniform ViewBlock { CameraView view; };

void main() {
    if (is_cut_out(map_surface(view.eye, materials[material_index], coordinates_at(view)).alpha, maps.cutoff))
        discard;
}
