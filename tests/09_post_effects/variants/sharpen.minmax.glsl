// right
#include "09_post_effects/picture_source.glsl"
vec3 sharpen(ivec2 pixel, mat3 kernel) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 9; ++i) {
        ivec2 at = min(max(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0)), picture_size() - 1);
        sum += texel(at) * kernel[i / 3][i % 3];
    }
    return max(sum, vec3(0.0));
}
