// A body of a few pixels or less: the light of 64 points of its disc, each spread over the pixels around it by a tent
// filter with a constant sum of 1. So the sum over the picture does not depend on its position.
#define BODY_SMALL  // 64 rays a pixel: too many for random walks
#include "17_planets/body.glsl"
#include "common/light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) uniform image2D result;
uniform sampler2D depth;

// [small_body]
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + body.corner;
    if (any(greaterThanEqual(pixel, imageSize(result))) || any(lessThan(pixel, ivec2(0)))) return;
    if (texelFetch(depth, pixel, 0).r > 0.0) return;
    float away = length(body.center);
    vec3 towards = body.center / away, side = normalize(cross(body.rays.down, towards)), up = cross(towards, side);
    vec3 right = body.rays.right, down = body.rays.down, forward = normalize(cross(down, right));
    forward *= sign(dot(forward, body.rays.corner));
    float pixel_rad = length(right), share = 3.14159265 * body.reach * body.reach / (away * away * pixel_rad * pixel_rad) / 64.0;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 64; ++i) {
        float r = sqrt((float(i) + 0.5) / 64.0), angle = 2.3999632 * float(i);
        vec3 place = towards + body.reach / away * r * (cos(angle) * side + sin(angle) * up), ray = normalize(place);
        float along = dot(ray, forward);
        if (along <= 0.0) continue;
        vec3 at = ray / along - body.rays.corner;
        vec2 from = abs(vec2(dot(at, right), dot(at, down)) / (pixel_rad * pixel_rad) - vec2(pixel) - 0.5);
        vec2 tent = max(1.0 - from, 0.0);
        if (tent.x * tent.y > 0.0) sum += tent.x * tent.y * share * seen_body(ray, body.reach / away / 40.0);
    }
    vec4 behind = imageLoad(result, pixel);
    imageStore(result, pixel, vec4(finite_light(sum.rgb + max(1.0 - sum.a, 0.0) * behind.rgb), 1.0));
}
// [/small_body]
