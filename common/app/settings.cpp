#include "common/app/settings.h"

#include <bit>
#include <cmath>

#include "common/gpu/pipeline.h"

namespace lightwalk {

std::string settings_of(const Module& module) {
    uint64_t hash = 1;
    for (const KnobBase* knob : module.all_knobs()) {
        const KnobBase::Numbers numbers = knob->numbers();
        if (numbers.count == 0) hash = mixed(hash, knob->variant());
        for (const float number : numbers)
            if (std::fabs(number) < 0x1p24f)
                hash = mixed(hash, std::bit_cast<uint32_t>(number));
            else
                hash = mixed(hash, hash_bytes(knob->text()));  // floats cannot represent large integers exactly
    }
    return {reinterpret_cast<const char*>(&hash), sizeof hash};
}

}  // namespace lightwalk
