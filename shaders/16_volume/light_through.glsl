// How much of the light gets through the volume to a place.

// Unit vector from a place to the light, and the length of that path within the volume, metres.
vec4 way_to_light(vec3 position) {
    vec3 way = volume_now.is_near > 0.0 ? volume_now.light_at - position : volume_now.light_at;
    float far = length(way);
    vec3 along = way / max(far, 1e-6);
    return vec4(along, volume_now.is_near > 0.0 ? far : volume_range(position, along).y);
}

// [through]
// The fraction of the light that gets through the volume to `position`: a second march, from there to the light. `turn` (0
// to 1) is where in each step it samples.
float light_through(vec3 position, float turn, int samples) {
    vec4 way = way_to_light(position);
    float through = 1.0, stride = way.w / float(samples);
    for (int i = 0; i < samples; ++i)
        through *= 1.0 - correct_opacity(classified(density_at(position + (float(i) + turn) * stride * way.xyz)).a, stride / REFERENCE_M);
    return through;
}
// [/through]

float extinction_of(float opacity) { return -log(max(1.0 - opacity, LEAST_TRANSMITTANCE)) / REFERENCE_M; }

// Optical depth of the same path.
float light_depth(vec3 position, float turn, int samples) {
    vec4 way = way_to_light(position);
    float sum = 0.0, stride = way.w / float(samples);
    for (int i = 0; i < samples; ++i)
        sum += stride * extinction_of(classified(density_at(position + (float(i) + turn) * stride * way.xyz)).a);
    return sum;
}
