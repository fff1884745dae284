// A knob as a slider, a switch or a list, made from its declaration.
#pragma once
#include "common/app/knob.h"

namespace lightwalk {

/// True where the person has changed it. Its help is the tooltip; a right click sets the default again.
bool knob_widget(KnobBase& knob);

}  // namespace lightwalk
