// right
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
