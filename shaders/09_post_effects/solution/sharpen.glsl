// Solution of 09.sharpen.
#include "09_post_effects/picture_source.glsl"

vec3 sharpen(ivec2 pixel, mat3 kernel) {
    vec3 sum = vec3(0.0);
    ivec2 last = picture_size() - 1;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            sum += kernel[row][column] * texel(clamp(pixel + ivec2(column, row) - 1, ivec2(0), last));
    return max(sum, 0.0);
}
