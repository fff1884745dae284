// Exercise 12.chart_step: find the fault in the step between two texels of the head's map.
// Starter: bright lines surround all charts in the picture of texels per millimetre.

// [chart_step]
// The map of the head consists of charts: pieces of the surface laid out flat. `own` is a texel
// of the map, `before` and `after` are its two neighbours on one axis. Each has the position of
// its surface in xyz, in metres, and the number of its chart in w. A neighbour with another
// number belongs to a piece of the head that may be anywhere.
//
// Returns the step on the surface from one texel to the next along that axis, in millimetres,
// found from neighbours of the same chart alone: with both of them the mean of the two steps, with
// one its step, with none (0, 0, 0).
//
// The function below has one fault. Find it by its symptom, and mend it.
// [/chart_step]
vec3 chart_step(vec4 before, vec4 own, vec4 after) {
    bool has_before = before.w == own.w, has_after = after.w == own.w;
    vec3 from = has_before ? before.xyz : own.xyz, to = has_after ? after.xyz : own.xyz;
    return 1000.0 * (to - from) / 2.0;
}
