#pragma once
#include <chrono>

#include "common/gpu/frame.h"

namespace lightwalk {

/// Load for a GPU that lowers its clock when idle. Short frames with pauses between them run at half the clock: an
/// H200 took 0.46 ms for the levels of 4096² texels and 0.31 ms for those of 8192², each interleaved with other
/// methods.
class GpuLoad {
  public:
    explicit GpuLoad(Gpu& gpu) : frame_(gpu) {}

    /// Keeps the device busy for so long, in frames of its own, and waits; up to half a second longer until they are as fast
    /// as those of the last load. Nothing at all on the software path. 3 ms before each of an H200's short frames were not enough
    /// for its clock, nor 30 ms after the processor had made a table for a tenth of a second.
    void run(std::chrono::milliseconds duration = std::chrono::milliseconds(30));

  private:
    Frame frame_;
    Buffer result_;
    uint32_t groups_ = 256;
    double least_ms_ = 1e9;  ///< of a group, in the fastest frame so far
};

}  // namespace lightwalk
