// One of the bloom's images in place of the picture. Where no blur ran, they hold anything.
#define DISPATCH_ACCESS readonly
#include "08_bloom/dispatches.glsl"
#include "08_bloom/look.glsl"

layout(scalar) uniform PictureInBlock { vec4 picture_in; };  // where the picture begins in it, and how large it is

void main() { look(dispatches[lit_at()] != 0u, picture_in.xy, picture_in.zw); }
