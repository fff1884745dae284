// Exercise 15.gerstner: how one wave moves the water.
// Starter: the water is level.

// [gerstner]
// The displacement (x, y, z), in metres, by one Gerstner wave of the water that rests at `at` =
// (x, z). `k` is the wave vector in 1/m, of any length above 0: the wave runs along it, and its
// wavelength is 2 pi / |k|. The phase of the wave at `at` is t = dot(k, at) - phase, with
// `phase` in radians. `amplitude` is in metres, `steepness` has no unit; both are 0 or more.
//
// The water rises by amplitude * sin(t). It moves along the wave's unit direction D = k / |k|
// by steepness * amplitude * cos(t). It thus gathers below the crests: crests become sharp and
// troughs broad. With steepness = 1 / (|k| amplitude) a crest is a cusp, and beyond that the
// water loops through itself.
//
// Tolerance: 1e-5 m plus 1e-4 of the value. F. Gerstner, "Theorie der Wellen", 1802.
// [/gerstner]
vec3 gerstner(vec2 at, vec2 k, float amplitude, float steepness, float phase) {
    return vec3(0.0);
}
