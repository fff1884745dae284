// Sound in memory.
#pragma once
#include <vector>

namespace lightwalk {

/// Mono. Sample i is at time i / rate_hz, in seconds.
struct Sound {
    int rate_hz = 0;
    std::vector<float> samples;  ///< amplitudes, nominally -1 to 1, not clipped
    double duration_s() const { return rate_hz > 0 ? double(samples.size()) / rate_hz : 0.0; }
};

}  // namespace lightwalk
