// Next mip of a cut-out: means of 2 × 2 texels, colours weighted by alpha. Odd sizes drop the last column or row, as
// blits do.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D finer;
layout(rgba32f) writeonly uniform image2D coarser;

void main() {
    ivec2 to = ivec2(gl_GlobalInvocationID.xy), last = textureSize(finer, 0) - 1;
    if (any(greaterThanEqual(to, imageSize(coarser)))) return;
    vec4 weighted = vec4(0.0), plain = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        vec4 texel = texelFetch(finer, min(2 * to + ivec2(i & 1, i >> 1), last), 0);
        weighted += texel * texel.a;
        plain += 0.25 * texel;
    }
    imageStore(coarser, to, vec4(plain.a > 0.0 ? weighted.rgb / (4.0 * plain.a) : plain.rgb, plain.a));
}
