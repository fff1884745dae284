// The mean of the transparent surfaces before the background, by their weights.
layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D sum;
uniform sampler2D share;  // of the background that is seen, by channel; of what no surface covers
layout(rgba16f) uniform image2D picture;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(picture)))) return;
    vec4 weighted = texelFetch(sum, at, 0);
    vec4 behind = texelFetch(share, at, 0);
    if (behind == vec4(1.0)) return;
    vec3 mean = weighted.rgb / max(weighted.a, 1e-10);
    vec4 before = imageLoad(picture, at);
    imageStore(picture, at, vec4((1.0 - behind.a) * mean + behind.rgb * before.rgb, before.a));
}
