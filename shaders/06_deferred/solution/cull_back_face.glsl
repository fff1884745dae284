// Solution of 06.cull_back_face.

bool is_back_face(vec3 a, vec3 b, vec3 c, bool mirrored) {
    float facing = dot(cross(b - a, c - a), a);  // negative if the normal points to the camera, the origin
    return (mirrored ? -facing : facing) >= 0.0;
}
