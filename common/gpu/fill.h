// Clears of targets by compute, where a device's rasteriser is far slower than its memory.
#pragma once
#include "common/gpu/frame.h"

namespace lightwalk {

/// Measures whether the rasteriser clears far slower than memory is filled. Waits.
bool clears_slowly(Gpu& gpu);

/// Whether compute clears targets faster than a load operation; measured once per device, false for software. An H100 takes
/// 300 µs to clear 1920×1080 half4 as a target or by a transfer, and 10 µs in compute.
bool fills_targets(Gpu& gpu);

/// For tests: overrules the measurement.
std::optional<bool>& fills_targets_always();

/// True for a large target that its pass clears, with one sample, of a format that shaders write.
bool can_fill(const Device& device, const Attachment& target, uint32_t layers);

/// Records, before a raster pass begins to draw, fills of its cleared targets; returns the statement with these kept.
RasterTargets fill_targets(Frame& frame, Commands& commands, const RasterTargets& targets);

}  // namespace lightwalk
