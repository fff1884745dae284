// right, in its pictures too
bool is_back_face(vec3 a, vec3 b, vec3 c, bool mirrored) {
    vec3 normal = cross(c - b, a - b);
    if (mirrored) normal = -normal;
    return !(dot(normal, b) < 0.0);
}
