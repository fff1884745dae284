// Colour of light that a surface scatters widely.
#include "04_surface_maps/surface_maps.glsl"

// A metal scatters none: its reflection, as far as it exceeds the 4% of other surfaces, stands in.
vec3 matt_color(Substance s) { return max(s.mixed.diffuse, s.ambient_specular - 0.04); }
