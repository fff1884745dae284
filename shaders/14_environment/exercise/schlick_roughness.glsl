// Exercise 14.schlick_roughness: how much of the light of all around a surface reflects.
// Starter: it reflects at every angle what it reflects when looked at straight on.

// [schlick_roughness]
// Schlick's approximation for a surface that reflects f0 when looked at along its normal: F
// = f0 + (f90 - f0) (1 - n·v)^5. A smooth surface reflects everything at grazing angles,
// f90 = 1. A rough one does not: most of its microfacets are not seen at a grazing angle.
// Take f90 = 1 - roughness, but never less than f0, channel by channel. By rounding,
// n_dot_v may lie a little outside 0 to 1: the result stays between f0 and f90. roughness
// and f0 are 0 to 1.
// [/schlick_roughness]
vec3 schlick_roughness(float n_dot_v, vec3 f0, float roughness) {
    return f0;
}
