// Charts grow by two texels, so that filtered reads at a border see the chart alone.
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D position, normal, albedo, stretch;
layout(rgba32f) writeonly uniform image2D wide_position;
layout(rgba16f) writeonly uniform image2D wide_normal, wide_albedo, wide_stretch;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = textureSize(position, 0), nearest = texel;
    if (any(greaterThanEqual(texel, size))) return;
    int least = 9;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
            ivec2 other = clamp(texel + ivec2(x, y), ivec2(0), size - 1);
            if (x * x + y * y < least && texelFetch(position, other, 0).w > 0.0) {
                least = x * x + y * y;
                nearest = other;
            }
        }
    imageStore(wide_position, texel, texelFetch(position, nearest, 0));
    imageStore(wide_normal, texel, texelFetch(normal, nearest, 0));
    imageStore(wide_albedo, texel, texelFetch(albedo, nearest, 0));
    // Grown texels have no surface of their own.
    vec4 scale = texelFetch(stretch, nearest, 0);
    imageStore(wide_stretch, texel, vec4(scale.xy, nearest == texel ? scale.z : 0.0, scale.w));
}
