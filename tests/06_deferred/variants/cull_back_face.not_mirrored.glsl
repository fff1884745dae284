// wrong: mirrored = 1
bool is_back_face(vec3 a, vec3 b, vec3 c, bool mirrored) { return dot(cross(b - a, c - a), a) >= 0.0; }
