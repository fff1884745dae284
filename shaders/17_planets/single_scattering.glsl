// A flat layer of particles that scatter light once (S. Chandrasekhar, Radiative Transfer, 1950, section 10): the share of
// P ω, in units of a white Lambertian surface that faces the sun. Cosines above 0, `depth` 0 or more.
#include "common/henyey_greenstein.glsl"

// (1 - e^-x) / x, also near 0.
float mean_of_exp(float x) { return x < 0.02 ? 1.0 - x * (0.5 - x / 6.0) : (1.0 - exp(-x)) / x; }

// On the side that the sun lights.
float scattered_back(float depth, float mu0, float mu) {
    float way = depth * (1.0 / mu + 1.0 / mu0);
    return 0.25 * depth / mu * mean_of_exp(way);
}

// On the other side: µ0 / (µ0 - µ) (e^(-τ/µ0) - e^(-τ/µ)), which is 0 / 0 where the two cosines are equal. Written with the
// mean of an exponential it has no difference of two numbers that are nearly the same.
float scattered_through(float depth, float mu0, float mu) {
    float a = depth / mu0, b = depth / mu;
    return 0.25 * b * exp(-min(a, b)) * mean_of_exp(abs(a - b));
}

// [more]
// Light scattered more often, as an addition to the phase function, the same in all directions. Fitted at one pair of
// directions; over Saturn's rings and four pairs it is off by -7 to +6% on the lit side, -75 to +113% on the other
// (tests/17_planets/test_ring_light.cpp, [17.rings_fit]).
float scattered_more(float depth, float albedo, bool lit) {
    return albedo * albedo * (lit ? 1.2 * (1.0 - exp(-2.0 * depth)) : 1.46 * (exp(0.92 * min(depth, 3.0)) - 1.0));
}
// [/more]

// Phase function of a ring's particles, with a mean of 1 over all directions: boulders that scatter back, and a
// fiftieth of dust that scatters forward. At phase angles from 5 to 34 degrees within 8% of 0.153 (pi - phase)^3.092,
// the power law quoted from L. Dones, J. Cuzzi and M. Showalter, Icarus 105, 1993.
float ring_particle_phase(float cos_phase) {
    return 0.98 * henyey_greenstein(cos_phase, 0.45, 1.0) + 0.02 * henyey_greenstein(-cos_phase, 0.7, 1.0);
}
