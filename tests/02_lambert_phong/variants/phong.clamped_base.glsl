// wrong: takes pow(0, 0)
float phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    if (dot(normal, to_light) <= 0.0) return 0.0;
    return pow(clamp(dot(reflect(-to_light, normal), to_eye), 0.0, 1.0), shininess);
}
