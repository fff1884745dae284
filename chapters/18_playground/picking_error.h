// How often picking is wrong.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "18_playground/picker.h"

namespace lightwalk {

struct Playground;

/// Adds `wrong_picks` to `error`: the share of pixels in which the method finds another item than the one that covers
/// most of the pixel, as 64 samples with cutouts see it. Where two items cover a pixel within an eighth of each other,
/// either is right.
void measure_picking(Playground& chapter, Gpu& gpu, glm::uvec2 size, nlohmann::json& error);

/// Of `fine`, ids at `times` the size, the share of pixels of `found` that are wrong.
double wrong_picks(const std::vector<uint32_t>& found, const std::vector<uint32_t>& fine, glm::uvec2 size,
                   uint32_t times);

}  // namespace lightwalk
