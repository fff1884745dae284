// Solution of 17.ring_phase.
vec3 ring_phase(vec3 back, vec3 forward, vec3 unlit, float cos_phase, float sun_side, float eye_side) {
    bool lit = (sun_side > 0.0 && eye_side > 0.0) || (sun_side < 0.0 && eye_side < 0.0);
    return lit ? mix(forward, back, 0.5 + 0.5 * cos_phase) : unlit;
}
