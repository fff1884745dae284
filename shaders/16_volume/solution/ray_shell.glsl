// Solution of 16.ray_shell.

// The half chord by the ray's nearest place to the centre: Haines et al., "Precision Improvements for Ray/Sphere
// Intersection", Ray Tracing Gems (2019), chapter 7.
vec2 ray_shell(vec3 origin, vec3 direction, float radius) {
    float nearest = -dot(origin, direction);
    vec3 beside = origin + nearest * direction;
    float rest = radius * radius - dot(beside, beside);
    if (rest <= 0.0) return vec2(0.0);
    float half_chord = sqrt(rest);
    return max(vec2(nearest - half_chord, nearest + half_chord), 0.0);
}
