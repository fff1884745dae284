// GPU time of a frame.
#pragma once
#include "common/gpu/frame.h"

namespace lightwalk {

/// Milliseconds of GPU time of the frame that ended last: the sum over all of its passes.
inline double gpu_ms(const Frame& frame) {
    double sum = 0;
    for (const PassTime& pass : frame.times) sum += pass.gpu_ms;
    return sum;
}

}  // namespace lightwalk
