// Depth alone: what is cut out leaves none.
#include "04_surface_maps/surface_maps.glsl"

void main() { seen_surface(); }
