// wrong: is_back_face(
bool is_back_face(vec3 a, vec3 b, vec3 c, bool mirrored) {
    float z = cross(b - a, c - a).z;
    return mirrored ? z >= 0.0 : z <= 0.0;
}
