// G-buffer pass: surface properties without lighting.
#include "06_deferred/mapped_pixel.glsl"
#include "06_deferred/put_pixel.glsl"

void main() { put_pixel(pixel_of(seen_surface())); }
