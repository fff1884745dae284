// The reference: the integral along a ray to the last digits that floats have.
#if VOLUME_METHOD == VOLUME_METHOD_EXACT

// -log(1 - opacity), also where 1 - opacity has rounded most of the opacity away.
float depth_of_opacity(float opacity) {
    float series = opacity * (1.0 + opacity * (0.5 + opacity * (1.0 / 3.0 + 0.25 * opacity)));
    return opacity < 0.02 ? series : -log(max(1.0 - opacity, 1e-30));
}

// 1 - exp(-depth), likewise.
float opacity_of_depth(float depth) { return depth < 0.02 ? depth * (1.0 - depth * (0.5 - depth / 6.0)) : 1.0 - exp(-depth); }

// Thousands of steps, each of an opacity near 1e-5: 1 - 1e-5 keeps two digits in a float, rounded in one direction. So
// steps add optical depth over a voxel, and voxels are composited. A step is cut if the transfer function changes
// within it, so that no part exceeds half of an entry.
vec4 march_exact(vec3 from, vec3 along, vec2 range, float step_m, int samples) {
    vec4 sum = vec4(0.0, 0.0, 0.0, 1.0);
    float way = range.y - range.x, voxel_m = step_m * float(samples);
    int voxels = int(ceil(way / voxel_m));
    float before = exact_density_at(from + range.x * along);
    for (int v = 0; v < voxels; ++v) {
        float begins = float(v) * voxel_m, length_m = min(voxel_m, way - begins) / float(samples), depth = 0.0;
        vec3 light = vec3(0.0);
        for (int i = 0; i < samples; ++i) {
            float at = range.x + begins + float(i) * length_m, after = exact_density_at(from + (at + length_m) * along);
            int parts = clamp(int(ceil(2.0 * float(TRANSFER_TEXELS) * abs(after - before))), 1, 32);
            before = after;
            for (int k = 0; k < parts; ++k) {
                vec3 position = from + (at + (float(k) + 0.5) / float(parts) * length_m) * along;
                vec4 looks = exactly_classified(exact_density_at(position));
                if (looks.a <= 0.0) continue;
                float part = depth_of_opacity(looks.a) * length_m / (float(parts) * REFERENCE_M);
                light += exp(-depth) * opacity_of_depth(part) * radiance_at(position, along, looks.rgb);
                depth += part;
            }
        }
        sum = vec4(sum.rgb + sum.a * light, sum.a * exp(-depth));
        if (sum.a * volume_now.brightest < 1e-5) break;
    }
    return sum;
}
#endif
