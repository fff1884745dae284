// Exercise 15.gerstner: how one wave moves the water.
// Until you fill it in, the water is level.

// [gerstner]
// By how much one Gerstner wave moves the water that rests at `at` = (x, z), as (x, y, z) in metres. `k` is the wave vector
// in 1/m, of any length above 0: the wave runs along it, and its wavelength is 2 pi / |k|. At rest the phase at `at` is
// t = dot(k, at) - phase, with `phase` in radians.
//
// The water rises by amplitude * sin(t). It moves along the wave's unit direction D = k / |k| by
// steepness * amplitude * cos(t), so that it gathers below the crests: crests become sharp and troughs broad. With
// steepness = 1 / (|k| amplitude) a crest is a cusp, beyond that the water loops through itself.
//
// Within 1e-5 plus a ten-thousandth. F. Gerstner, "Theorie der Wellen", 1802.
// [/gerstner]
vec3 gerstner(vec2 at, vec2 k, float amplitude, float steepness, float phase) {
    return vec3(0.0);
}
