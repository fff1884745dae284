// Last step of a frame for pictures in physical units: a tone curve without an upper limit.
#pragma once
#include "common/gpu/frame.h"

namespace lightwalk {

/// In place of encode_srgb(): linear light x to the codes of 1 - exp(-x) in frame.output.
void encode_film(Frame& frame);

}  // namespace lightwalk
