#pragma once
#include "common/gpu/frame.h"

namespace lightwalk {

/// Work for a GPU whose clock falls when it has little to do. Frames of half a millisecond with the processor's work
/// between them are measured at half the clock of frames of ten: an H200 took 0.46 ms for the levels of 4096² texels and
/// 0.31 ms for those of 8192², each beside what else was measured in turn.
class GpuLoad {
  public:
    explicit GpuLoad(Gpu& gpu) : frame_(gpu) {}

    /// A frame of its own, which keeps the device busy for 2 to 4 ms. Nothing at all on a software device. Waits.
    void run();

  private:
    Frame frame_;
    Buffer result_;
    uint32_t groups_ = 256;
};

}  // namespace lightwalk
