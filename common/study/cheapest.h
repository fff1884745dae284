// The need rule's choice among what was measured.
#pragma once
#include <cstddef>
#include <vector>

namespace lightwalk {

struct Measured {
    double error = 0;
    double time_ms = 0;
    bool enough = false;  ///< within the budget
};

/// Number of the most accurate: of those that are enough and, within 2%, as fast as the fastest of these; of all where none
/// is enough. `all` is not empty.
inline size_t cheapest(const std::vector<Measured>& all) {
    constexpr double as_fast = 1.02;  // times are known so well
    const Measured* fastest = nullptr;
    for (const Measured& m : all)
        if (m.enough && (!fastest || m.time_ms < fastest->time_ms)) fastest = &m;
    const Measured* choice = nullptr;
    for (const Measured& m : all)
        if (!fastest || (m.enough && m.time_ms <= as_fast * fastest->time_ms))
            if (!choice || !(m.error >= choice->error)) choice = &m;
    return static_cast<size_t>(choice - all.data());
}

}  // namespace lightwalk
