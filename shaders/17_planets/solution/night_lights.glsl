// Solution of 17.night_lights.
vec3 night_lights(vec3 city, float cosine, float cloud) {
    float s = clamp(-cosine / 0.12, 0.0, 1.0);
    return city * s * s * (3.0 - 2.0 * s) * (1.0 - cloud);
}
