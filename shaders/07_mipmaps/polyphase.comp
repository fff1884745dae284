// One level from the one above it: the mean over just the area of a texel, of three by three texels where sizes are odd.
// (NVIDIA, "Non-Power-of-Two Mipmap Creation", 2005.)
#include "07_mipmaps/level.glsl"
#include "07_mipmaps/odd_size_weights.glsl"

void main() {
    ivec2 at;
    if (!begin(at)) return;
    vec3 across = odd_size_weights(at.x, source_size().x), down = odd_size_weights(at.y, source_size().y);
    vec4 mean = vec4(0.0);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x)
            // Texels of weight 0 are not read: they may lie outside, and 0 times infinity is NaN.
            if (across[x] * down[y] > 0.0) mean += across[x] * down[y] * texel(2 * at + ivec2(x, y));
    end(at, mean);
}
