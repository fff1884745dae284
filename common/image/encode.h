// Pictures as bytes of a file, without a file.
#pragma once
#include <string>

#include "common/image/image.h"

namespace lightwalk {

/// A PNG with alpha. Throws Failure if memory ends.
std::string encode_png(const Image8& image);

/// A JPEG without alpha; `quality` from 1 to 100. Throws Failure if memory ends.
std::string encode_jpeg(const Image8& image, int quality);

}  // namespace lightwalk
