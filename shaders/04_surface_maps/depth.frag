// Depth only, with cut-outs discarded.
#include "04_surface_maps/surface_maps.glsl"

void main() { seen_surface(); }
