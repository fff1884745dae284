// wrong: of a level above of 1x6 texels
#include "07_mipmaps/source.glsl"

vec4 box_2x2(ivec2 at) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) sum += 0.25 * texel(2 * at + ivec2(i & 1, i >> 1));
    return sum;
}
