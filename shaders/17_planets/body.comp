// A body over its background, in the pixels around it.
#include "17_planets/body.glsl"
#include "common/light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) uniform image2D result;
uniform sampler2D depth;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + body.corner;
    if (any(greaterThanEqual(pixel, imageSize(result))) || any(lessThan(pixel, ivec2(0)))) return;
    if (texelFetch(depth, pixel, 0).r > 0.0) return;
    vec3 ray = ray_through(body.rays, vec2(pixel) + 0.5);
    vec4 light = seen_body(normalize(ray), length(body.rays.right) / dot(ray, ray));
    if (light.a <= 0.0 && light.rgb == vec3(0.0)) return;
    vec4 behind = imageLoad(result, pixel);
    imageStore(result, pixel, vec4(finite_light(light.rgb + (1.0 - light.a) * behind.rgb), 1.0));
}
