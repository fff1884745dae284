// right
float sphere_shadow_hard(vec3 to_center, float radius, vec3 to_light) {
    vec3 side = cross(to_center, to_light);
    return dot(to_center, to_light) > 0.0 && dot(side, side) < radius * radius ? 0.0 : 1.0;
}

float sphere_shadow_power(vec3 to_center, float radius, vec3 to_light, float width, float power) {
    if (sphere_shadow_hard(to_center, radius, to_light) > 0.0) return 1.0;
    float depth = (radius - length(cross(to_center, to_light))) / width;
    return depth >= 1.0 || depth <= 0.0 ? float(depth <= 0.0) : 1.0 - exp2(power * log2(depth));
}

// The angles under which the middles see half of the chord.
float hidden_share(float radius, float gap) {
    const float pi = 3.14159265;
    float apart = radius + gap;
    if (gap >= 1.0) return 0.0;
    if (apart <= abs(1.0 - radius)) return radius < 1.0 ? radius * radius : 1.0;
    if (radius > 300.0) return 0.5 - (asin(gap) + gap * sqrt(1.0 - gap * gap)) / pi;
    float suns = clamp((gap * (2.0 * radius + gap) + 1.0) / (2.0 * apart), -1.0, 1.0);
    float height = sqrt(1.0 - suns * suns);
    float planets = atan(height, apart - suns);
    float flat_part = planets < 0.02 ? 2.0 / 3.0 * planets * planets * planets
                                     : planets - sin(planets) * cos(planets);
    return (acos(suns) - suns * height + radius * radius * flat_part) / pi;
}
