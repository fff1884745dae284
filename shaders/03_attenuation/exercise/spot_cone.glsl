// Exercise 03.spot_cone: the edge of a spot light.
// Starter: a spot light shines in all directions.

// [spot_cone]
// The fraction of a spot light's intensity in one direction. `cosine` is the cosine of the
// angle between that direction and the cone's axis. The result is 1 where `cosine` is
// cos_inner or more, and 0 where it is cos_outer or less. In between, t rises from 0 to 1,
// linearly in the cosine, and the result is t raised to mix(1, 0.35, softness); `softness`
// is 0 to 1. The two angles may be equal: this is a hard edge, not a division by 0, and
// exactly on it both 0 and 1 are accepted.
// [/spot_cone]
float spot_cone(float cosine, float cos_inner, float cos_outer, float softness) {
    return 1.0;
}
