// A knob as a slider, a switch or a list, made from its declaration.
#pragma once
#include "common/app/knob.h"

namespace lightwalk {

/// True where the person has changed it. `beside` stands at the end of its row. Its help is the tooltip; a right click
/// sets the default again.
bool knob_widget(KnobBase& knob, const std::string& beside = "");

}  // namespace lightwalk
