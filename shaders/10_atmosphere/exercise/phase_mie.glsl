// Exercise 10.phase_mie: the phase function of dust and droplets, which scatter mostly forward.
// Starter: they scatter equally in all directions.

// [phase_mie]
// Returns the phase function of Cornette and Shanks for dust. With c = cos_angle, the
// cosine of the angle between the old and the new direction, they published
//
//     3/2 (1 - g^2) / (2 + g^2) * (1 + c^2) / (1 + g^2 - 2 g c)^(3/2)
//
// g is -0.99 to 0.99; 0 gives Rayleigh's function. Two decisions are left to you.
// - Normalisation: in the published form the integral over all directions is 4 pi. Here
//   it must be 1, as for 10.phase_rayleigh.
// - Accuracy: the result must be right to 0.05%. For g = 0.99 and c = 1 the bracket is
//   0.0001, the difference of two numbers near 2, of which a float has lost most
//   digits; rounding may even make it negative. Write it as a sum of terms that are not
//   negative: (1 - g)^2 is one of them for g of 0 or more, (1 + g)^2 for g below 0.
// [/phase_mie]
float phase_mie(float cos_angle, float g) {
    return 0.25 / 3.14159265;
}
