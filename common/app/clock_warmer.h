// Load that keeps a GPU at full clock.
#pragma once
#include <chrono>

#include "common/gpu/frame.h"

namespace lightwalk {

/// Keeps a GPU at full clock during measurements: with pauses between frames, an H200 runs at half its clock.
class ClockWarmer {
  public:
    explicit ClockWarmer(Gpu& gpu) : frame_(gpu) {}

    /// Keeps the device busy for `duration`, up to 0.5 s longer until it is at full speed. Blocks. Nothing on the software path.
    void run(std::chrono::milliseconds duration = std::chrono::milliseconds(30));

  private:
    Frame frame_;
    Buffer result_;
    uint32_t groups_ = 256;
    double least_ms_ = 1e9;
};

}  // namespace lightwalk
