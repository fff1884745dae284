// Exercise 12.gaussian_profile: how much of the light that enters skin at a point leaves it r mm away.
// Until you fill it in, light leaves evenly over a disc of 9 mm.
#include "12_skin/profile.h"

// [gaussian_profile]
// Returns what leaves at a distance of r_mm >= 0, in 1/mm², for red, green and blue: the sum over the six Gaussians of
// skin_weight[i] times a Gaussian of the plane whose variance along each axis is skin_variance_mm2[i]. The integral of a
// Gaussian over the plane is 1, and so is that of the sum. Books print three Gaussians that look alike: exp(-r²/2v) with
// 1/(2 pi v), exp(-r²/v) without a factor, and 1/sqrt(2 pi v). Which of them has the integral 1 over a plane?
// [/gaussian_profile]
vec3 gaussian_profile(float r_mm) { return vec3(r_mm < 9.0 ? 0.00393 : 0.0); }
