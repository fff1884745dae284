// Depth only, without cut-outs.
#include "04_surface_maps/surface_maps.glsl"

void main() { seen_surface(); }
