// wrong: box_2x2(at = (0, 0)
#include "07_mipmaps/source.glsl"

vec4 box_2x2(ivec2 at) {
    // Centred on the even texel instead of between the two.
    ivec2 a = max(2 * at - 1, ivec2(0)), b = min(2 * at, source_size() - 1);
    return 0.25 * (texel(a) + texel(ivec2(b.x, a.y)) + texel(ivec2(a.x, b.y)) + texel(b));
}
