// wrong: layer_width =
vec3 density(float height, float rayleigh_height, float mie_height, float layer_center, float layer_width) {
    float h = max(height, 0.0);
    vec3 d = vec3(0.0);
    if (rayleigh_height > 0.0) d.x = exp(-h / rayleigh_height);
    if (mie_height > 0.0) d.y = exp(-h / mie_height);
    if (layer_width > 0.0) d.z = max(0.0, 1.0 - 2.0 * abs(h - layer_center) / layer_width);
    return d;
}
