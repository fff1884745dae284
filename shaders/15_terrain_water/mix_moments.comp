// The transparent surfaces, each dimmed by those before it, over the background, dimmed by all of them.
layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D sum;
uniform sampler2D absorbance;
uniform sampler2D tints;  // product of all
layout(rgba16f) uniform image2D picture;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(picture)))) return;
    float all = texelFetch(absorbance, at, 0).r;
    vec3 tint = texelFetch(tints, at, 0).rgb;
    if (all == 0.0 && tint == vec3(1.0)) return;
    vec4 dimmed = texelFetch(sum, at, 0);
    // The sum's own alpha only weighs it; the opacity of all surfaces is known exactly.
    float behind = exp(-all);
    vec4 before = imageLoad(picture, at);
    vec3 mixed = behind * tint * before.rgb + (1.0 - behind) * dimmed.rgb / max(dimmed.a, 1e-5);
    imageStore(picture, at, vec4(mixed, before.a));
}
