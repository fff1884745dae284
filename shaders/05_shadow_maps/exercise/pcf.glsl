// Exercise 05.pcf: percentage-closer filtering, four texels at a time.
// Starter: it compares with the one texel that holds the point.
#include "05_shadow_maps/shadow_data.h"

// [pcf]
// The share, 0 to 1, of a square of the map from which light reaches the point. The square
// is centred on r.place.xy and `kernel` texels wide (odd). A texel blocks the light if its
// depth is greater than the depth of the surface's plane at the texel's centre, which is
// never below 0. The square seldom begins at a texel's edge: it overlaps kernel + 1 texels
// along u and along v. Each outer texel counts by the part of it that the square covers, so
// the result changes smoothly with the point.
//
// gather_depths() reads the four texels that meet at a corner, for the price of one read;
// plane_depths() returns the depths of the plane at their centres, in the same order. No
// texel may be gathered twice: (kernel + 1)² / 4 gathers in all. Gather exactly at texel
// corners: elsewhere the device may round to other texels than you expect.
// [/pcf]
float pcf(Receiver r, uint layer, int kernel) {
    return float(r.place.z >= read_depth(r.place.xy, layer));
}
