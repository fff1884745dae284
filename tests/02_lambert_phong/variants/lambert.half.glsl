// wrong: lambert(
float lambert(vec3 normal, vec3 to_light) {
    return max(0.5 * dot(normal, to_light), 0.0);
}
