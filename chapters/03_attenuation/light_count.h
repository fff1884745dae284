// Mean number of lights computed per pixel of a picture.
#pragma once
#include "common/gpu/gpu.h"

namespace lightwalk {

/// The mean of `hdr`'s alpha over all pixels: with the knob `show` at light_count that is the number of lights that a
/// pixel has computed, 0 for the background. Counts above 2,048 are rounded, as half floats are. Waits.
double mean_light_count(Gpu& gpu, const Image& hdr);

}  // namespace lightwalk
