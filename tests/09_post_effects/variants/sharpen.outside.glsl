// wrong: sharpen(
#include "09_post_effects/picture_source.glsl"
vec3 sharpen(ivec2 pixel, mat3 kernel) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 9; ++i) sum += texel(pixel + ivec2(i % 3 - 1, i / 3 - 1)) * kernel[i / 3][i % 3];
    return max(sum, 0.0);
}
