// Debug views.

#if VOLUME_SHOW == VOLUME_SHOW_BLOCKS
// The edges of the blocks that a ray meets: gold where they hold something, blue where they are empty.
vec3 block_edges(vec3 from, vec3 along, vec2 range) {
    vec3 lines = vec3(0.0);
    float t = range.x, weight = 1.0;
    for (int i = 0; i < 64 && t < range.y; ++i) {
        vec3 position = from + (t + 1e-4) * along;
        bool empty;
        float leaves = block_leaves(to_texture(position) * volume_now.size, voxels_a_metre(along), t + 1e-4, empty);
        ivec3 block = clamp(ivec3(to_texture(position) * volume_now.size / float(BLOCK_VOXELS)), ivec3(0), textureSize(volume_blocks, 0) - 1);
        int levels = int(round(255.0 * texelFetch(volume_blocks, block, 0).r)), edge = BLOCK_VOXELS << max(levels - 1, 0);
        vec3 inside = fract(to_texture(position) * volume_now.size / float(edge));
        vec3 border = min(inside, 1.0 - inside) * float(edge);  // voxels from the faces, one of them the entry
        float least = min(border.x, min(border.y, border.z)), most = max(border.x, max(border.y, border.z));
        float second = border.x + border.y + border.z - least - most;
        float line = 1.0 - smoothstep(0.1, 0.35, second);
        lines += weight * line * (empty ? vec3(0.03, 0.08, 0.2) : vec3(0.75, 0.42, 0.12));
        weight *= empty ? 0.96 : 0.4;
        t = max(leaves, t + 1e-3);
    }
    return lines;
}
#endif

#if VOLUME_SHOW == VOLUME_SHOW_NOISE
// Five octaves of it.
float noise_octaves(vec3 at, NoiseMoment moment) {
    float sum = 0.0, height = 0.6;
    for (int i = 0; i < 5; ++i) {
        sum += height * moving_noise(at, moment);
        at = 2.03 * vec3(0.8 * at.x - 0.6 * at.y, 0.6 * at.x + 0.8 * at.y, at.z) + 3.7;
        height *= 0.5;
        ++moment.seed;
    }
    return sum;
}

// Four moments of the shell's noise, a third of a cell apart, as a surface that is lit from the upper left.
vec3 noise_phases(vec2 pixel, vec2 size) {
    vec2 half_size = 0.5 * size;
    ivec2 quarter = ivec2(greaterThanEqual(pixel, half_size));
    NoiseMoment moment = volume_now.moment;
    float phase = float(quarter.x + 2 * quarter.y) / 3.0;
    moment.time += phase;
    moment.cell += int(floor(moment.time));
    moment.time = fract(moment.time);
    moment.skew_time += 0.309016994 * phase;
    vec3 at = vec3(volume.shell_scale * 2.0 * (pixel - half_size * vec2(quarter)) / half_size.y, 0.37);
    float here = noise_octaves(at, moment);
    vec2 slope = vec2(noise_octaves(at + vec3(0.02, 0.0, 0.0), moment), noise_octaves(at + vec3(0.0, 0.02, 0.0), moment)) - here;
    vec3 normal = normalize(vec3(-14.0 * slope, 1.0));
    float lit = max(dot(normal, normalize(vec3(-0.6, -0.7, 0.6))), 0.0);
    float shine = pow(max(dot(normal, normalize(vec3(-0.3, -0.35, 0.9))), 1e-4), 60.0);
    return mix(vec3(0.02, 0.06, 0.2), vec3(0.9, 0.5, 0.2), smoothstep(-0.7, 0.7, here)) * (0.12 + lit) + 0.5 * shine;
}
#endif
