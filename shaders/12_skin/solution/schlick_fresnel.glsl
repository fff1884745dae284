// Solution of 12.schlick_fresnel.

float schlick_fresnel(float cosine, float f0) {
    float away = 1.0 - clamp(cosine, 0.0, 1.0), square = away * away;
    return f0 + (1.0 - f0) * square * square * away;
}
