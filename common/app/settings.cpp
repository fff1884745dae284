#include "common/app/settings.h"

namespace lightwalk {

std::string settings_of(const Module& module) {
    std::string result;
    for (const KnobBase* knob : module.all_knobs()) result += knob->text() + " ";
    return result;
}

}  // namespace lightwalk
