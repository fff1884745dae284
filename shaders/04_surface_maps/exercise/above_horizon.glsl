// Exercise 04.above_horizon: find the fault in the clipping of a lamp by the horizon.
// Starter: a lamp that sinks into the floor loses light in steps, one corner at a time.

// [above_horizon]
// An edge of a lamp runs straight from `end` to `other`, seen from a surface point at the
// origin. The horizon is z = 0, and at least one of the two is above it. Returns `end` where
// it is above the horizon, and otherwise the point at which the edge crosses the horizon,
// with a z of exactly 0. The result changes steadily as `end` sinks below the horizon.
//
// The function below has one fault. Find it by its symptom, and mend it.
// [/above_horizon]
vec3 above_horizon(vec3 end, vec3 other) {
    float share = end.z > 0.0 ? 0.0 : 1.0;  // of the way from the end to the other one
    return mix(end, other, share);
}
