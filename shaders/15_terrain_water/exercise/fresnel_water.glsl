// Exercise 15.fresnel_water: how much of the light a water surface reflects.
// Until you fill it in, the water reflects as little at every angle as it does straight from above.

// [fresnel_water]
// The share of light, 0 to 1, that the surface between air and water reflects, by Schlick's formula F0 + (1 - F0) (1 - c)^5.
// `cosine`: of the angle between the direction to the eye and the normal on the eye's side; 0 to 1, or outside of it by
// rounding. `eye_index` and `other_index`: the refractive indices where the eye is and on the other side, 1 and 1.333 or the
// other way round.
//
// F0 is ((n1 - n2) / (n1 + n2))^2, about 0.0204 for water. In Schlick's formula c is the cosine on the side of the smaller
// index. So for an eye below the water it has to be found first, by Snell's law: sin_t = eye_index / other_index * sin_i.
// Where that sine is 1 or more no light gets through, and the result is 1 (total reflection: beyond 48.6 degrees).
// Where the two indices are equal there is no surface: F0 is 0, and Schlick's formula holds as it stands.
//
// Within 1e-4; near the angle of total reflection, where it rises steeply, within 1e-2.
// [/fresnel_water]
float fresnel_water(float cosine, float eye_index, float other_index) {
    return 0.02;
}
