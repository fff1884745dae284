// One level from the one above it: the mean of two by two texels. Of an odd size the last column or row is left out.
#include "07_mipmaps/level.glsl"
#include "07_mipmaps/box_2x2.glsl"

void main() {
    ivec2 at;
    if (begin(at)) end(at, box_2x2(at));
}
