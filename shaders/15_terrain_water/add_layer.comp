// The next layer behind the peeled ones.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D layer;
layout(rgba32f) uniform image2D peeled;  // light of the layers so far; how much of the rest is seen

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(peeled)))) return;
    vec4 next = texelFetch(layer, at, 0), before = imageLoad(peeled, at);
    imageStore(peeled, at, vec4(before.rgb + before.a * next.a * next.rgb, before.a * (1.0 - next.a)));
}
