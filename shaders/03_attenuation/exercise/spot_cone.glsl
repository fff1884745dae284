// Exercise 03.spot_cone: the edge of a spot light.
// Until you fill it in, a spot light shines all around.

// [spot_cone]
// 1 where `cosine`, of the angle to the cone's axis, is cos_inner or more, 0 where it is cos_outer or less. In between t
// goes from 0 to 1 in proportion to the cosine, and the result is t to the power of mix(1, 0.35, softness), softness from
// 0 to 1. The two angles may be equal: that is a hard edge, not a division by 0, and upon it both 0 and 1 are right.
// [/spot_cone]
float spot_cone(float cosine, float cos_inner, float cos_outer, float softness) {
    return 1.0;
}
