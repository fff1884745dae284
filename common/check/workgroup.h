// Runs the joint work of a workgroup, with its invocations in several orders.
#pragma once
#include <string>
#include <vector>

#include "common/gpu/gpu.h"

namespace lightwalk {

/// A device runs the invocations of a workgroup in an order of its own, and software one after the other from barrier
/// to barrier: a barrier that is missing may go unseen for ever. So each case is run once for each of
/// `workgroup_orders`, in which other invocations are early and late; `local` says which one an invocation stands for.
struct WorkgroupRun {
    std::string include;  ///< "03_attenuation/tile_lights.glsl": the exercise or the solution, by the toggle
    std::string before;   ///< GLSL that the file expects: `given[]` has the words below, `case_index` selects the case
    std::string call;     ///< GLSL: calls its functions for `local` and reports results with put(i, uint)
    std::vector<uint32_t> given;
    uint32_t cases = 1;
    uint32_t puts = 1;    ///< i is below this
    uint32_t counts = 0;  ///< `before` may say check_count(i) of so many i: how often it was said in a case and order
    Macros macros = {};
};

inline constexpr uint32_t workgroup_size = 256, workgroup_orders = 4;

/// Values reported by put(): for each case, order, invocation (by `local`) and i. Throws ShaderError if the file does
/// not compile.
class WorkgroupResults {
  public:
    WorkgroupResults(Gpu& gpu, const WorkgroupRun& run);
    uint32_t at(uint32_t which, uint32_t order, uint32_t local, uint32_t i) const {
        return words_[((size_t(which) * workgroup_orders + order) * workgroup_size + local) * stride_ + i];
    }
    /// As barriers_wrong() says it, of the first workgroup with something wrong. Behind each of a WorkgroupRun's texts
    /// memoryBarrierShared() and its like do nothing (traced_barriers()).
    std::string barriers() const;

    uint32_t count(uint32_t which, uint32_t order, uint32_t i) const {
        return counted_[(size_t(which) * workgroup_orders + order) * counts_ + i];
    }

  private:
    uint32_t cases_, stride_, counts_;
    std::vector<uint32_t> words_, counted_;
};

}  // namespace lightwalk
