// wrong: density(height = -
vec3 density(float height, float rayleigh_height, float mie_height, float layer_center, float layer_width) {
    vec3 d = vec3(0.0);
    if (rayleigh_height > 0.0) d.x = exp(-height / rayleigh_height);
    if (mie_height > 0.0) d.y = exp(-height / mie_height);
    if (layer_width > 0.0) d.z = max(0.0, 1.0 - abs(height - layer_center) / layer_width);
    return d;
}
