// wrong: tone_curve(
vec3 tone_curve(vec3 radiance) {
    vec3 v = radiance;
    return clamp((v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081), 0.0, 1.0);
}
