// An image in place of the picture.
#include "08_bloom/look.glsl"

void main() { look(true, vec2(0.0), vec2(textureSize(image, 0))); }
