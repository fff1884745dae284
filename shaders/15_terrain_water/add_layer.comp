// The next layer behind the peeled ones.
#include "15_terrain_water/tint_through.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D layer, layer_tint;
layout(rgba32f) uniform image2D peeled;  // light of the layers so far
layout(rgba32f) uniform image2D passed;  // share of the light behind them that is seen, by channel

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(peeled)))) return;
    vec4 next = texelFetch(layer, at, 0);
    vec3 light = imageLoad(peeled, at).rgb, left = imageLoad(passed, at).rgb;
    imageStore(peeled, at, vec4(light + left * next.a * next.rgb, 1.0));
    imageStore(passed, at, vec4(tint_through(left, next.a, texelFetch(layer_tint, at, 0).rgb), 1.0));
}
