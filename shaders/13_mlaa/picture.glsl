// The source picture: linear light, made finite, with its border repeated outside.
#include "common/light.glsl"

uniform sampler2D picture;

vec3 light_at(ivec2 pixel) {
    ivec2 inside = clamp(pixel, ivec2(0), textureSize(picture, 0) - 1);
    return finite_light(texelFetch(picture, inside, 0).rgb);
}
