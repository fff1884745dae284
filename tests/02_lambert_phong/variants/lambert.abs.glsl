// wrong: lambert(
float lambert(vec3 normal, vec3 to_light) {
    return abs(dot(normal, to_light));
}
