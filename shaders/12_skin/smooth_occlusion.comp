// Mean over three by three texels of a chart: removes the noise of few rays, keeps corners dark.
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D from;
layout(rgba16f) writeonly uniform image2D into;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(into);
    if (any(greaterThanEqual(texel, size))) return;
    vec4 own = texelFetch(from, texel, 0);
    vec2 sum = vec2(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            vec4 other = texelFetch(from, clamp(texel + ivec2(x, y), ivec2(0), size - 1), 0);
            if (other.a == own.a) sum += vec2(other.r, 1.0);
        }
    imageStore(into, texel, vec4(sum.x / sum.y, 0.0, 0.0, own.a));
}
