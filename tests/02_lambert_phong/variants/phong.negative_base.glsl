// wrong: takes pow(
float phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    float cosine = min(dot(reflect(-to_light, normal), to_eye), 1.0);
    return dot(normal, to_light) > 0.0 ? max(pow(cosine, shininess), 0.0) : 0.0;
}
