// Image encoding in memory.
#pragma once
#include <string>

#include "common/image/image.h"

namespace lightwalk {

/// PNG with alpha. Throws Failure if out of memory.
std::string encode_png(const Image8& image);

/// JPEG without alpha; `quality` 1 to 100. Throws Failure if out of memory.
std::string encode_jpeg(const Image8& image, int quality);

}  // namespace lightwalk
