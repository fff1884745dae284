// Exercise 15.gerstner_normal: the normal of many waves.
// Starter: the water is shaded as if it were level.

// [gerstner_normal]
// Two functions. The water that rests at (x, z) lies at P(x, z) = (x, 0, z) + the sum of
// the displacements by all waves. One wave at `at` = (x, z) has the phase t = dot(k, at) - phase:
// it lifts the water by amplitude * sin(t), and moves it along D = k / |k| by steepness *
// amplitude * cos(t).
//
// gerstner_slopes(): the derivatives of one wave's displacement, without the (x, 0, z), as a
// matrix. The first column is the derivative by x, the third that by z; the second is 0.
//
// gerstner_normal(): the unit normal of the surface at a point, along dP/dz cross dP/dx.
// `slopes` is the sum of gerstner_slopes() over all waves there. Level water, all slopes 0,
// has the normal (0, 1, 0). The published shortcut, (-sum of D |k| A cos, 1 - sum of Q |k| A
// sin), is exact for a single wave only: the tangents dP/dx and dP/dz have to be summed over
// all waves before their cross product is taken. Where the surface folds over, this normal
// points down: leave it so. A cross product whose length is exactly 0, at a cusp, gives (0, 1,
// 0).
//
// Tolerance: 1e-5 plus 1e-4 of the value for slopes, 1e-4 for normals.
// [/gerstner_normal]
mat3 gerstner_slopes(vec2 at, vec2 k, float amplitude, float steepness, float phase) {
    return mat3(0.0);
}

vec3 gerstner_normal(mat3 slopes) {
    return vec3(0.0, 1.0, 0.0);
}
