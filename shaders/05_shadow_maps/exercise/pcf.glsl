// Exercise 05.pcf: percentage-closer filtering, four texels at a time.
// Until you fill it in, it asks the one texel that holds the point.
#include "05_shadow_maps/shadow_data.h"

// [pcf]
// The part of a square of the map around r.place.xy, `kernel` texels wide (odd), from which the light's way to the point
// is free: 0 to 1. A texel whose depth is greater than the surface's own in that texel's middle, which is never below 0, is
// in the way. The square seldom begins at a texel's edge: it lies on kernel + 1 texels along u and along v, and counts the
// outer ones by the part of them that it covers. So it moves smoothly with the point.
//
// gather_depths() reads the four texels that meet in a corner, for the price of one; plane_depths() says where the surface
// is in the middle of each, in the same order. No texel may be gathered twice: (kernel + 1)² / 4 gathers in all. A corner
// is the exact place to gather at: elsewhere the device may round to other texels than you think.
// [/pcf]
float pcf(Receiver r, uint layer, int kernel) {
    return float(r.place.z >= read_depth(r.place.xy, layer));
}
