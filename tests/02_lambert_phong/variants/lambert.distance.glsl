// right
float lambert(vec3 normal, vec3 to_light) {
    vec3 apart = normal - to_light;
    return max(1.0 - dot(apart, apart) / 2.0, 0.0);
}
