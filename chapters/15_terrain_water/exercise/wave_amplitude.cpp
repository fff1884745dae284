// Exercise 15.wave_amplitude: from a measured spectrum to the amplitude of one wave.
// Starter: no wave has an amplitude, and the sea is level.
#include "15_terrain_water/exercises.h"

namespace lightwalk::exercise {

// [wave_amplitude]
// The sea's height is a sum over wave vectors that form a square grid in the plane of k, with a
// distance of `step` (1/m, above 0) along both axes. Each wave vector has the random complex
// amplitude h0 = (n1 + i n2) a: n1 and n2 are independent normal numbers of mean 0 and variance
// 1, and a, in metres, is the result of this function. The real height is the sum of
// h0(k) exp(i k x) and its complex conjugate's share at -k, so its variance is the sum of
// 2 |h0|^2 over all wave vectors. On average this sum has to be the spectrum's integral.
//
// `density` is the spectrum at this wave's frequency: the variance of the height per angular
// frequency, in m^2 s, 0 or more. Deep water has omega^2 = g |k| with g = 9.81 m/s^2. `k` is the
// length of the wave vector, in 1/m, 0 or more, and `along` the cosine of its angle to the wind,
// -1 to 1. The directions share the density as 2 / pi * along^2 per radian; waves against the
// wind, with `along` at most 0, have an amplitude of 0. So has k = 0.
//
// Three steps: change the variable from omega to k; a ring of the grid's plane between k and
// k + dk has an area of k dk per radian; one wave stands for an area of step^2.
//
// Tolerance: 1% of the variance of many waves.
// [/wave_amplitude]
double wave_amplitude(double density, double k, double along, double step) {
    (void)density, (void)k, (void)along, (void)step;
    return 0;
}

}  // namespace lightwalk::exercise
