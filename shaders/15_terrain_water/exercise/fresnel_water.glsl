// Exercise 15.fresnel_water: how much of the light a water surface reflects.
// Starter: the water reflects as little at every angle as it does straight from above.

// [fresnel_water]
// The share of light, 0 to 1, that the surface between air and water reflects, by Schlick's
// formula F0 + (1 - F0) (1 - c)^5. `cosine` is the cosine of the angle between the direction to
// the eye and the normal on the eye's side: 0 to 1, or outside of this range by rounding.
// `eye_index` is the refractive index on the eye's side, `other_index` that on the other side:
// 1 and 1.333, the other way round below the water, or any other two indices of at least 1.
//
// F0 is ((n1 - n2) / (n1 + n2))^2, about 0.0204 for water. In Schlick's formula c is the cosine
// on the side of the smaller index. For an eye on the side of the larger one, below the water,
// c is therefore the cosine of the refracted ray: its sine is sin_t = eye_index / other_index *
// sin_i by Snell's law, with sin_i the sine of the given angle. Where sin_t is 1 or more no
// light gets through, and the result is 1 (total reflection: beyond 48.6 degrees). Where the
// two indices are equal F0 is 0, and Schlick's formula holds unchanged. GLSL's asin() and
// acos() may be wrong by 1e-3: take sines and cosines from each other by sqrt() instead.
//
// Tolerance: 1e-4. Within 0.02 of the onset of total reflection the formula is steep: there the
// result for a cosine that differs by up to 1e-4 is right, too.
// [/fresnel_water]
float fresnel_water(float cosine, float eye_index, float other_index) {
    return 0.02;
}
