// wrong: gave false, expected true
bool is_back_face(vec3 a, vec3 b, vec3 c, bool mirrored) {
    float facing = dot(cross(b - a, c - a), a);
    return mirrored ? facing < 0.0 : facing > 0.0;
}
