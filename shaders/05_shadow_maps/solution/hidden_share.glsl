// Solution of 05.hidden_share.

// Area of the segment that a chord at the distance `at` from the centre cuts off a disc of radius 1. (An arc cosine is
// less precise.)
float segment(float at) {
    float x = clamp(at, -1.0, 1.0), half_chord = sqrt((1.0 - x) * (1.0 + x));
    return atan(half_chord, x) - x * half_chord;
}

float hidden_share(float radius, float gap) {
    const float pi = 3.14159265;
    if (gap >= 1.0) return 0.0;
    if (gap <= (radius >= 1.0 ? -1.0 : 1.0 - 2.0 * radius)) return min(radius * radius, 1.0);  // one disc inside the other
    float apart = radius + gap;  // between the centres
    // Distance of the chord from the sun's centre, (apart^2 + 1 - radius^2) / (2 apart), with the difference of squares
    // written as a product.
    float chord = (gap * (2.0 * radius + gap) + 1.0) / (2.0 * apart);
    float suns = segment(chord);
    if (radius <= 16.0) return (suns + radius * radius * segment((apart - chord) / radius)) / pi;
    // The planet's segment is so flat that it is a parabola's, with an area of 2/3 of its box.
    float half_chord = sqrt(max((1.0 - chord) * (1.0 + chord), 0.0));
    return (suns + 2.0 / 3.0 * half_chord * half_chord * half_chord / radius) / pi;
}
