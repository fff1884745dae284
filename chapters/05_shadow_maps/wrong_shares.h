// Share of a picture's pixels with each kind of shadow error.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "common/gpu/gpu.h"

namespace lightwalk {

/// Adds the percentages of surface pixels with acne, peter_panning, leak and edge (shadow_error.h), from a picture
/// with 1 and the kind of error, or 0 for the background, in alpha. RGBA16F.
void wrong_shares(Gpu& gpu, const Image& picture, nlohmann::json& error);

}  // namespace lightwalk
