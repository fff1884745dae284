// How much of the light gets through the volume to a place.

// [through]
// The fraction of the light that gets through the volume to `position`: a second march, from there to the light. `turn` (0
// to 1) is where in each step it samples.
float light_through(vec3 position, float turn, int samples) {
    vec3 way = volume_now.is_near > 0.0 ? volume_now.light_at - position : volume_now.light_at;
    float far = length(way);
    vec3 along = way / max(far, 1e-6);
    if (volume_now.is_near == 0.0) far = volume_range(position, along).y;
    float through = 1.0, stride = far / float(samples);
    for (int i = 0; i < samples; ++i)
        through *= 1.0 - correct_opacity(classified(density_at(position + (float(i) + turn) * stride * along)).a, stride / REFERENCE_M);
    return through;
}
// [/through]
