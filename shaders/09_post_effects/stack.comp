// As many stages as the macros say: all that are on, or one.
#include "09_post_effects/stages.glsl"

layout(local_size_x = 32, local_size_y = 4) in;

#ifdef FULL_FLOATS
layout(rgba32f) uniform image2D into;
#else
layout(rgba16f) uniform image2D into;
#endif
#ifndef IN_PLACE
uniform sampler2D from;
#endif

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(into)))) return;
    ivec2 pixel = at + ivec2(post_now.origin);  // of the whole picture, of which this may be a part
    vec2 uv = (vec2(pixel) + 0.5) / post_now.whole;
#ifdef IN_PLACE
    vec3 c = imageLoad(into, at).rgb;
#else
    vec3 c = texelFetch(from, at, 0).rgb;
#endif
    imageStore(into, at, vec4(all_stages(c, pixel, uv), 1.0));
}
