#pragma once
#include <chrono>

#include "common/gpu/frame.h"

namespace lightwalk {

/// Work for a GPU whose clock falls when it has little to do. Frames of half a millisecond with the processor's work
/// between them are measured at half the clock of frames of ten: an H200 took 0.46 ms for the levels of 4096² texels
/// and 0.31 ms for those of 8192², each beside what else was measured in turn.
class GpuLoad {
  public:
    explicit GpuLoad(Gpu& gpu) : frame_(gpu) {}

    /// Keeps the device busy for so long, in frames of its own, and waits. Nothing at all on a software device. 3 ms
    /// before each of an H200's short frames were not enough for its clock.
    void run(std::chrono::milliseconds duration = std::chrono::milliseconds(30));

  private:
    Frame frame_;
    Buffer result_;
    uint32_t groups_ = 256;
};

}  // namespace lightwalk
