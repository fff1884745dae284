// Pictures from the device.
#pragma once
#include "common/gpu/gpu.h"
#include "common/image/image.h"

namespace lightwalk {

/// Level 0 of an image as linear RGB: of half floats, floats, or sRGB-encoded bytes. Waits.
ImageRgb read_linear(Gpu& gpu, const Image& image);

/// An 8-bit picture as it is. Waits.
Image8 read_picture(Gpu& gpu, const Image& image);

}  // namespace lightwalk
