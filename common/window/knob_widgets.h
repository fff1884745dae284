// A knob as a slider, a switch or a list, made from its declaration.
#pragma once
#include "common/app/knob.h"
#include "common/window/auto_choices.h"

namespace lightwalk {

/// The name in words, without its unit; with it where another knob of the module would be called the same: "sun (klx)"
/// beside "sun (degrees)".
std::string label_of(const KnobBase& knob);

/// Width of a column for the labels of these knobs, in pixels; labels that need more than half of the panel get a
/// line of their own.
float label_column(const KnobList& knobs);

/// True if the person has changed it. `beside` stands at the end of its row. Its help is the tooltip. A knob that is
/// not at its default has a mark, and a button that sets the default again; so does a right click. `automatic`: adds the
/// entry "auto" to the methods that it offers it for.
bool knob_widget(KnobBase& knob, float label_width, const std::string& beside = "", AutoChoices* automatic = nullptr);

/// An arrow that turns back. True if it was clicked; `place` is logged for tests.
bool reset_button(const std::string& place);

/// Of a choice's help, the part that speaks of one option: "a fixed kernel (pcf)" of "Shadow filter: one comparison
/// (hard), a fixed kernel (pcf)". Empty if no part says more than the option's name.
std::string option_help(const std::string& help, const std::string& option);

}  // namespace lightwalk
