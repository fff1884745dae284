// Exercise 14.slice_integral: the share of light that a slice lets through between its horizons.
// Starter: the whole slice is open.

// [slice_integral]
// Angles in a slice, in radians, from the line of sight on: the horizon on the one side at
// `before` (-pi to 0), on the other side at `after` (0 to pi); the surface's normal, projected
// into the slice, at `tilt` (-pi/2 to pi/2).
//
// No light arrives from below the surface: first limit `before` to tilt - pi/2 at least and
// `after` to tilt + pi/2 at most. Then return
//
//     the integral from before to after of cos(a - tilt) |sin(a)| da
//
// which is 1 for tilt = 0 between -pi/2 and pi/2. Mind the sign of sin(a): split the integral at
// 0. cos(a - tilt) sin(a) is the derivative of -cos(2 a - tilt) / 4 + a sin(tilt) / 2.
// [/slice_integral]
float slice_integral(float before, float after, float tilt) {
    return 1.0;
}
