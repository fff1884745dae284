// Exercise 06.cull_back_face: triangles that face away from the camera.
// Starter: none is culled: the picture is right, and nothing is saved.

// [cull_back_face]
// True if the camera sees the triangle a, b, c from behind or edge-on, or if the triangle
// has no area. The corners are vectors from the camera, in metres, and may lie behind it.
// Seen from the front, a, b, c run counter-clockwise; those of a `mirrored` instance run
// clockwise. Test the triangle's plane, not its projection: a corner behind the camera
// projects to the wrong side of the screen.
// [/cull_back_face]
bool is_back_face(vec3 a, vec3 b, vec3 c, bool mirrored) {
    return false;
}
