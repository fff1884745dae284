// Solution of 07.box_2x2.
#include "07_mipmaps/source.glsl"

vec4 box_2x2(ivec2 at) {
    ivec2 a = 2 * at, b = min(a + 1, source_size() - 1);  // of one texel b is a, which then counts twice
    return 0.25 * (texel(a) + texel(ivec2(b.x, a.y)) + texel(ivec2(a.x, b.y)) + texel(b));
}
