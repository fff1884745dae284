// An image in place of the picture.
#include "08_bloom/look.glsl"

void main() { look(true); }
