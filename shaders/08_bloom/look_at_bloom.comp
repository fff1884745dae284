// One of the bloom's images in place of the picture. Where no blur ran, they hold anything.
#define DISPATCH_ACCESS readonly
#include "08_bloom/dispatches.glsl"
#include "08_bloom/look.glsl"

void main() { look(dispatches[lit_at()] != 0u); }
