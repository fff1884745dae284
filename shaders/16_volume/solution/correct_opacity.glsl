// Solution of 16.correct_opacity.

// Transmittances of layers in a row multiply.
float correct_opacity(float opacity, float ratio) {
    if (ratio <= 0.0 || opacity <= 0.0) return 0.0;
    if (opacity >= 1.0) return 1.0;
    return 1.0 - pow(1.0 - opacity, ratio);
}
