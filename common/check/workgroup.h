// Checks of workgroup functions under several invocation orders.
#pragma once
#include <string>
#include <vector>

#include "common/gpu/gpu.h"

namespace lightwalk {

/// Cases run in several orders of invocations, since one order may hide missing barriers. `local`: index represented.
struct WorkgroupRun {
    std::string include;  ///< file with the exercise or solution, by toggle
    std::string before;   ///< required GLSL; may read `given[]` and `case_index`
    std::string call;     ///< GLSL that calls the exercise for `local` and reports with put(i, uint)
    std::vector<uint32_t> given;
    uint32_t cases = 1;
    uint32_t puts = 1;
    uint32_t counts = 0;  ///< i of check_count(i), callable in `before`, is below this; counted per case and order
    Macros macros = {};
};

inline constexpr uint32_t workgroup_size = 256, workgroup_orders = 4;

/// Values of put() by case, order, `local` and i. Throws ShaderError if the file does not compile.
class WorkgroupResults {
  public:
    WorkgroupResults(Gpu& gpu, const WorkgroupRun& run);
    uint32_t at(uint32_t which, uint32_t order, uint32_t local, uint32_t i) const {
        return words_[((size_t(which) * workgroup_orders + order) * workgroup_size + local) * stride_ + i];
    }
    /// barriers_wrong() of the first faulty workgroup.
    std::string barriers() const;

    uint32_t count(uint32_t which, uint32_t order, uint32_t i) const {
        return counted_[(size_t(which) * workgroup_orders + order) * counts_ + i];
    }

  private:
    uint32_t cases_, stride_, counts_;
    std::vector<uint32_t> words_, counted_;
};

}  // namespace lightwalk
