// The film's fade, of a picture in linear light.
#include "19_ambiance/fade_linear_light.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(rgba16f) uniform image2D picture;
layout(scalar) uniform FadeBlock { vec2 faded; };

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    vec4 light = imageLoad(picture, pixel);
    imageStore(picture, pixel, vec4(fade_linear_light(max(light.rgb, 0.0), faded.x, faded.y), light.a));
}
