// wrong: hidden_share(
// How deep the line towards the light is inside the sphere, in metres; below 0 where it passes beside it, or the sphere
// is behind.
float depth_in_sphere(vec3 to_center, float radius, vec3 to_light) {
    float along = dot(to_center, to_light);
    return along > 0.0 ? radius - length(to_center - along * to_light) : -1.0;
}

float sphere_shadow_hard(vec3 to_center, float radius, vec3 to_light) {
    return depth_in_sphere(to_center, radius, to_light) > 0.0 ? 0.0 : 1.0;
}

float sphere_shadow_power(vec3 to_center, float radius, vec3 to_light, float width, float power) {
    float depth = clamp(depth_in_sphere(to_center, radius, to_light) / width, 0.0, 1.0);
    return depth > 0.0 ? 1.0 - pow(depth, power) : 1.0;
}

// Of a disc of radius 1 what lies beyond a chord at `at` from its middle, as an area. (An arc cosine is less precise.)
float segment(float at) {
    float x = clamp(at, -1.0, 1.0), half_chord = sqrt((1.0 - x) * (1.0 + x));
    return atan(half_chord, x) - x * half_chord;
}

float hidden_share(float radius, float gap) {
    const float pi = 3.14159265;
    if (gap >= 1.0) return 0.0;
    if (gap <= (radius >= 1.0 ? -1.0 : 1.0 - 2.0 * radius)) return min(radius * radius, 1.0);  // one disc in the other
    float apart = radius + gap;  // from middle to middle
    // Where the chord crosses the line of the middles, from the sun's: (apart^2 + 1 - radius^2) / (2 apart), and the
    // difference of squares as a product.
    float chord = (gap * (2.0 * radius + gap) + 1.0) / (2.0 * apart);
    float suns = segment(chord);
    if (radius <= 1e9) return (suns + radius * radius * segment((apart - chord) / radius)) / pi;
    // The planet's segment is so flat that it is a parabola's, whose area is 2/3 of its box.
    float half_chord = sqrt(max((1.0 - chord) * (1.0 + chord), 0.0));
    return (suns + 2.0 / 3.0 * half_chord * half_chord * half_chord / radius) / pi;
}
