// wrong: divides
vec3 density(float height, float rayleigh_height, float mie_height, float layer_center, float layer_width) {
    float h = max(height, 0.0);
    return vec3(exp(-h / rayleigh_height), exp(-h / mie_height), max(0.0, 1.0 - abs(h - layer_center) / layer_width));
}
