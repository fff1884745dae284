// A piece of sound in memory.
#pragma once
#include <vector>

namespace lightwalk {

/// One channel. Sample i belongs to the time i / rate_hz seconds.
struct Sound {
    int rate_hz = 0;             ///< samples per second
    std::vector<float> samples;  ///< about -1 to 1; louder ones are kept as they are
    double duration_s() const { return rate_hz > 0 ? double(samples.size()) / rate_hz : 0.0; }
};

}  // namespace lightwalk
