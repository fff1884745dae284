// Exercise 17.ring_phase: which of three tables a ring is seen by.
// As it stands every ring is seen as from the sun.

// [ring_phase]
// Three tables say how bright a ring is at this radius: `back` with the sun behind the camera, `forward` against the sun,
// both on the side that the sun lights, and `unlit` on the other side, by what comes through. `cos_phase` is the cosine of
// the phase angle, between the directions from the ring to the sun and to the camera: 1 is `back`, -1 is `forward`, and
// between them the share of `back` is (1 + cos_phase) / 2. (cos_phase itself as the share extrapolates: at -1 it gives
// 2 forward - back, which may be negative.) `sun_side` and `eye_side` are the components of those two directions along
// the ring's normal: the lit side is seen where both have one sign. A ring seen exactly from the edge, 0, is unlit.
// [/ring_phase]
vec3 ring_phase(vec3 back, vec3 forward, vec3 unlit, float cos_phase, float sun_side, float eye_side) {
    return back;
}
