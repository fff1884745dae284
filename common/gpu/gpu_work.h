// Work besides the commands of frames, counted for each thread.
#pragma once
#include <cstdint>

namespace lightwalk {

/// Large enough to be felt in a frame: none of it should happen while a picture is waited for.
struct GpuWork {
    uint64_t pipelines = 0;    ///< built
    uint64_t allocations = 0;  ///< of device memory
    uint64_t transfers = 0;    ///< submitted and waited for: Gpu::submit_now
    double ended_ms = 0;       ///< end of the last frame whose times were read, on the device's clock
};
inline thread_local GpuWork gpu_work;

}  // namespace lightwalk
