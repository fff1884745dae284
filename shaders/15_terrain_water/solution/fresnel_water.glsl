// Reflectance of a water surface from above and from below.

// [fresnel_water]
// C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Computer Graphics Forum 13(3), 1994.
float fresnel_water(float cosine, float eye_index, float other_index) {
    float c = clamp(cosine, 0.0, 1.0), root = (eye_index - other_index) / (eye_index + other_index), f0 = root * root;
    if (eye_index > other_index) {
        float ratio = eye_index / other_index, sine_square = ratio * ratio * (1.0 - c * c);
        if (sine_square >= 1.0) return 1.0;
        c = sqrt(1.0 - sine_square);
    }
    float left = 1.0 - c, square = left * left;
    return f0 + (1.0 - f0) * square * square * left;
}
// [/fresnel_water]
