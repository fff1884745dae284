// right, in its pictures too
bool is_back_face(vec3 a, vec3 b, vec3 c, bool mirrored) {
    float sides = dot(a, cross(b - a, c - b));
    return mirrored ? sides <= 0.0 : sides >= 0.0;
}
