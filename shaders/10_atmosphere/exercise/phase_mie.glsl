// Exercise 10.phase_mie: which way dust and droplets scatter: mostly on.
// Until you fill it in, they scatter the same in all directions.

// [phase_mie]
// Cornette and Shanks: 3/2 (1 - g²)/(2 + g²) · (1 + c²)/(1 + g² - 2 g c)^(3/2), c the cosine of the angle by which the light
// is turned, for unpolarised light and an integral over all directions of 4 pi. Here the integral must be 1. g is -0.99 to
// 0.99; 0 gives Rayleigh's function. No pow of what may be rounded below 0.
// [/phase_mie]
float phase_mie(float cos_angle, float g) {
    return 0.25 / 3.14159265;
}
