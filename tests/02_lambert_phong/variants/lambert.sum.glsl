// right
float lambert(vec3 normal, vec3 to_light) {
    vec3 sum = normal + to_light;
    return clamp(0.5 * dot(sum, sum) - 1.0, 0.0, 1.0);
}
