// Exercise 10.phase_rayleigh: the phase function of molecules.
// Starter: molecules scatter equally in all directions.

// [phase_rayleigh]
// Returns Rayleigh's phase function: proportional to 1 + cos_angle^2, where cos_angle
// is the cosine of the angle between the old and the new direction of the light.
// Scattering neither creates nor destroys light: the integral of the function over all
// directions, 4 pi steradians, is 1.
// [/phase_rayleigh]
float phase_rayleigh(float cos_angle) {
    return 0.25 / 3.14159265;
}
