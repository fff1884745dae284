// Exercise 17.ring_phase: which of three tables a ring is seen by.
// Starter: every ring is seen as from the sun.

// [ring_phase]
// Three tables give the radiance of a ring at this radius: `back` and `forward` on the side
// that the sun lights, with the sun behind the camera and with the camera facing the sun; and
// `unlit` on the other side, where light comes through the ring. Returns the radiance for two
// directions, from the ring to the sun and to the camera. `sun_side` and `eye_side` are the
// components of these directions along the ring's normal. The camera sees the lit side if both
// have the same sign, and the unlit side otherwise, also if either is 0. `cos_phase` is the
// cosine of the angle between the two directions: on the lit side the result is `back` at 1,
// `forward` at -1, and between them `back` has the share (1 + cos_phase) / 2. (With cos_phase
// itself as the share, -1 would give 2 forward - back, which may be negative.)
// [/ring_phase]
vec3 ring_phase(vec3 back, vec3 forward, vec3 unlit, float cos_phase, float sun_side, float eye_side) {
    return back;
}
