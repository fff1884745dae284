#include "common/app/settings.h"

#include <cmath>

namespace lightwalk {
namespace {

// Bytes rather than text: some are compared in every frame.
template <class T>
void append(std::string& to, const T& value) {
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::string settings_of(const Module& module) {
    std::string result;
    for (const KnobBase* knob : module.all_knobs()) {
        const KnobBase::Numbers numbers = knob->numbers();
        if (numbers.count == 0) append(result, knob->variant());
        for (const float number : numbers)
            if (std::fabs(number) < 0x1p24f)
                append(result, number);
            else
                result += knob->text();  // a float does not hold every integer that large
    }
    return result;
}

}  // namespace lightwalk
