// right
vec3 density(float height, float rayleigh_height, float mie_height, float layer_center, float layer_width) {
    if (height < 0.0) height = 0.0;
    vec3 d = vec3(0.0);
    if (rayleigh_height > 0.0) d.x = 1.0 / exp(height / rayleigh_height);
    if (mie_height != 0.0) d.y = exp2(-1.442695041 * height / mie_height);
    float away = abs(height - layer_center);
    if (away < layer_width) d.z = (layer_width - away) / layer_width;
    return d;
}
