// wrong: is_back_face(
bool is_back_face(vec3 a, vec3 b, vec3 c, bool mirrored) {
    vec2 p = a.xy / -a.z, q = b.xy / -b.z, r = c.xy / -c.z;
    float area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    return mirrored ? area >= 0.0 : area <= 0.0;
}
