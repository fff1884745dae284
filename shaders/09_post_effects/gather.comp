// One of the effects that look at other pixels: each needs the whole picture of the one before.
#include "09_post_effects/chromatic_aberration.glsl"
#include "09_post_effects/noise.glsl"
#include "09_post_effects/post_block.glsl"
#include "09_post_effects/radial_blur.glsl"
#include "09_post_effects/sharpen.glsl"

layout(local_size_x = 32, local_size_y = 4) in;
writeonly uniform image2D into;

// Each channel is read elsewhere; and rows are torn to the sides by noise, red one way and blue the other.
vec3 split_channels(vec2 uv, ivec2 pixel) {
    float torn = post.aberration_rows * noise_of(uvec2(7u, uint(pixel.y) / 3u), post_now.grain_frame);
    vec3 color;
    for (int i = 0; i < 3; ++i)
        color[i] = picture(aberrated(uv, post.aberration_shift[i]) + vec2(torn * float(1 - i), 0.0))[i];
    return color;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(into)))) return;
    vec2 uv = (vec2(at) + 0.5) / vec2(imageSize(into));
#if POST_RADIAL_BLUR
    vec3 c = radial_blur(uv, post_now.mouse, post.blur_by, post.blur_taps);
#elif POST_ABERRATION
    vec3 c = split_channels(uv, at);
#elif POST_SHARPEN
    const mat3 identity = mat3(0, 0, 0, 0, 1, 0, 0, 0, 0);
    vec3 c = sharpen(at, identity + post.sharpen_by * (post_now.kernel - identity));
#else
    vec3 c = texel(at);
#endif
    imageStore(into, at, vec4(c, 1.0));
}
