// Per-thread counters of expensive work, which should stand still in an interactive frame.
#pragma once
#include <cstdint>

namespace lightwalk {

struct GpuWork {
    uint64_t pipelines = 0;
    uint64_t allocations = 0;
    uint64_t transfers = 0;
    uint64_t macro_lists = 0;  ///< module macro lists rebuilt
    uint64_t searches = 0;     ///< pipeline look-ups by shader text
    uint64_t lists = 0;        ///< scene item lists built or compared
    uint64_t sets = 0;
    uint64_t command_buffers = 0;
    double waited_ms = 0;
    double ended_ms = 0;  ///< end of the last timed frame, device clock
};
inline thread_local GpuWork gpu_work;

}  // namespace lightwalk
