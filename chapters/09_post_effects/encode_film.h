// Last step of a frame for pictures in physical units: a tone curve without an upper limit.
#pragma once
#include "common/gpu/frame.h"

namespace lightwalk {

/// Instead of encode_srgb(): encodes 1 - exp(-x) of linear light x in frame.output.
void encode_film(Frame& frame);

}  // namespace lightwalk
