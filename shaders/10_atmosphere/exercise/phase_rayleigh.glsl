// Exercise 10.phase_rayleigh: which way molecules scatter.
// Until you fill it in, they scatter the same in all directions.

// [phase_rayleigh]
// In proportion to 1 + cos_angle², where cos_angle is the cosine of the angle by which the light is turned. No light is made
// and none is lost: integrated over all directions, which are 4 pi steradians, it is 1.
// [/phase_rayleigh]
float phase_rayleigh(float cos_angle) {
    return 0.25 / 3.14159265;
}
