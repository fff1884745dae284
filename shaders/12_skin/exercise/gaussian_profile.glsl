// Exercise 12.gaussian_profile: the fraction of light that leaves skin r mm from where it entered.
// Starter: light leaves uniformly over a disc of 9 mm.
#include "12_skin/profile.h"

// [gaussian_profile]
// Returns the fraction of light, per mm^2, that leaves at the distance r_mm >= 0 from
// the point of entry, for red, green and blue: the sum over the six Gaussians of
// skin_weight[i] times a Gaussian of the plane with the variance skin_variance_mm2[i]
// along each axis. SKIN_GAUSSIANS is their number.
//
// The integral over the plane has to be 1 in each channel. The weights add up to 1, so
// the integral of each Gaussian must be 1 as well. Books print three forms for a
// variance v: exp(-r^2 / 2v) with the factor 1 / (2 pi v), exp(-r^2 / v) without a
// factor, and exp(-r^2 / 2v) with the factor 1 / sqrt(2 pi v). Decide which one has the
// integral 1 over a plane; the integral of f(r) over the plane is that of f(r) 2 pi r
// dr.
// [/gaussian_profile]
vec3 gaussian_profile(float r_mm) { return vec3(r_mm < 9.0 ? 0.00393 : 0.0); }
