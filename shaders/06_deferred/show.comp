// View of a decoded G-buffer channel.
#include "06_deferred/read_gbuffer.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) uniform image2D hdr;

vec3 shown(Pixel p, float depth, float lights) {
#if GBUFFER_SHOW == GBUFFER_SHOW_NORMAL
    return 0.5 + 0.5 * p.normal;
#elif GBUFFER_SHOW == GBUFFER_SHOW_FACING
    return 0.5 + 0.5 * p.facing;
#elif GBUFFER_SHOW == GBUFFER_SHOW_DIFFUSE
    return p.material.mixed.diffuse;
#elif GBUFFER_SHOW == GBUFFER_SHOW_SPECULAR
    return p.material.mixed.specular;
#elif GBUFFER_SHOW == GBUFFER_SHOW_GLOSS
    return vec3(log2(1.0 + p.material.mixed.shininess) / log2(1.0 + most_shininess));
#elif GBUFFER_SHOW == GBUFFER_SHOW_OCCLUSION
    return vec3(p.material.occlusion);
#elif GBUFFER_SHOW == GBUFFER_SHOW_POSITION
    return fract(p.position + 0.5);  // repeats every metre; offset so that surfaces at 0 do not flicker
#elif GBUFFER_SHOW == GBUFFER_SHOW_DEPTH
    return vec3(1.0 / (1.0 + 0.1 * distance(p.position, view.eye)));
#else
    float share = clamp(log2(1.0 + lights) / 7.0, 0.0, 1.0);  // blue, pink at 10, orange at 50, white at 127
    return clamp(vec3(2.5 * share - 0.5, 3.0 * share - 2.0, min(share * 2.0, 1.2 - 1.6 * share) + 3.0 * max(share - 0.8, 0.0)), 0.0, 1.0);
#endif
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(hdr)))) return;
    float depth = depth_of(at), lights = imageLoad(hdr, at).a;
    vec3 color = depth == 0.0 ? vec3(0.0) : shown(read_pixel(at, depth), depth, lights);
    imageStore(hdr, at, vec4(color, lights));
}
