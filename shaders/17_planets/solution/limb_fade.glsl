// Solution of 17.limb_fade.
float limb_fade(float opacity, float mu, float width) {
    if (mu <= 0.0) return 0.0;
    float s = clamp(mu / width, 0.0, 1.0);
    float hidden = opacity >= 1.0 ? 1.0 : 1.0 - pow(1.0 - opacity, 1.0 / mu);
    return hidden * s * s * (3.0 - 2.0 * s);
}
