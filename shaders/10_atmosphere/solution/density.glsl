// Solution of 10.density.
float thinning(float height, float scale_height) { return scale_height > 0.0 ? exp(-height / scale_height) : 0.0; }

vec3 density(float height, float rayleigh_height, float mie_height, float layer_center, float layer_width) {
    height = max(height, 0.0);
    float layer = layer_width > 0.0 ? max(0.0, 1.0 - abs(height - layer_center) / layer_width) : 0.0;
    return vec3(thinning(height, rayleigh_height), thinning(height, mie_height), layer);
}
