// right
float phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    float cosine = dot(to_light, reflect(-to_eye, normal));
    if (dot(normal, to_light) <= 0.0 || cosine <= 0.0) return 0.0;
    return exp(shininess * log(min(cosine, 1.0)));
}
