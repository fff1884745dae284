// Per-thread counters of expensive work, which should stand still in an interactive frame.
#pragma once
#include <cstdint>

namespace lightwalk {

struct GpuWork {
    uint64_t pipelines = 0;
    uint64_t allocations = 0;
    uint64_t transfers = 0;
    double ended_ms = 0;  ///< end of the last timed frame, device clock
};
inline thread_local GpuWork gpu_work;

}  // namespace lightwalk
