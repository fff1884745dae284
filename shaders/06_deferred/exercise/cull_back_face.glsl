// Exercise 06.cull_back_face: which triangles does nobody see?
// Until you fill it in, none is culled: the picture is right, and nothing is saved.

// [cull_back_face]
// True where the eye sees the triangle a, b, c from behind, from the edge, or where it has no area. The corners are
// vectors from the eye, in metres, and may lie behind it. Seen from the front a, b, c run counter-clockwise; those of a
// `mirrored` instance clockwise. Ask the plane, not the picture: where a corner is behind the eye, its place on the
// screen is on the wrong side.
// [/cull_back_face]
bool is_back_face(vec3 a, vec3 b, vec3 c, bool mirrored) {
    return false;
}
