// The level above: texel(p) is one of its texels as numbers that may be averaged, p from (0, 0) to source_size() - 1.
#include "07_mipmaps/content.glsl"

uniform sampler2DArray source;
int layer = 0;
ivec2 source_size() { return textureSize(source, 0).xy; }
vec4 texel(ivec2 at) { return decode(texelFetch(source, ivec3(at, layer), 0)); }
