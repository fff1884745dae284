// Exercise 15.moment_transmittance: the light that reaches a surface, from four moments of the absorbance on its way.
// Starter: no surface dims another, so every layer counts the same, wherever it lies.

// [moment_transmittance]
// A pixel's layers have the absorbance `all` together, above 0; `b` holds the means of z, z², z³
// and z⁴ over it. Of all distributions of absorbance with these four means, take the one that lies
// at the depth `z` itself, from -1 to 1, and at only two other depths. In front of z lies the
// absorbance of each depth nearer than z (a smaller number), none of a farther one, and the
// fraction `overestimation` of what lies at z. Returns the transmittance of the absorbance in
// front of z.
//
// A pixel with one or two layers has almost singular equations: only 1e-5 of `b` are then means of
// a wide distribution, mixed in by the caller. A determinant loses that to rounding. Eliminate step
// by step instead. Tolerance: 2e-3.
// [/moment_transmittance]
float moment_transmittance(vec4 b, float all, float z, float overestimation) {
    return 1.0;
}
