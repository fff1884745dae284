// Item numbers, with cut-outs discarded.
#include "04_surface_maps/surface_maps.glsl"
#include "18_playground/id_buffer.glsl"

layout(location = 0) out uint id;

void main() {
    seen_surface();  // discards
    id = id_of(item);
}
