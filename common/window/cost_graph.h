// The cost of the last seconds' pictures as a graph.
#pragma once
#include <deque>
#include <vector>

#include "common/gpu/frame.h"

namespace lightwalk {

class CostGraph {
  public:
    static constexpr double seconds = 10.0;

    void note(const std::vector<PassTime>& times, double frame_ms);  ///< a new picture's
    void draw() const;

  private:
    struct Cost {
        double at_s, gpu_ms, frame_ms;
    };
    std::deque<Cost> costs_;
};

}  // namespace lightwalk
