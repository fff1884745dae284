// The need rule's choice among measured methods.
#pragma once
#include <cstddef>
#include <vector>

namespace lightwalk {

struct Measured {
    double error = 0;
    double time_ms = 0;
    bool enough = false;  ///< within the budget
};

/// Index of the most accurate method: of those that suffice and are within 2% of the fastest such one; of all if none
/// suffices. `all` is not empty.
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
