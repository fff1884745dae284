// Solution of 02.phong (B. T. Phong, Illumination for Computer Generated Pictures, 1975).

float phong(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    float cosine = dot(reflect(-to_light, normal), to_eye);
    bool lit = dot(normal, to_light) > 0.0 && cosine > 0.0;
    // min: the dot product of two unit vectors can round to just above 1, which a large power would blow up.
    return lit ? pow(min(cosine, 1.0), shininess) : 0.0;
}
