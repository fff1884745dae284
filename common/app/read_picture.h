// Pictures from the device.
#pragma once
#include "common/gpu/gpu.h"
#include "common/image/image.h"

namespace lightwalk {

/// The view's first mip and layer as linear RGB: of half floats, floats, or sRGB-encoded bytes. Waits.
ImageRgb read_linear(Gpu& gpu, const ImageView& view);

/// The same of an 8-bit picture, as it is. Waits.
Image8 read_picture(Gpu& gpu, const ImageView& view);

}  // namespace lightwalk
