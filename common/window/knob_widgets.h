// A knob as a slider, a switch or a list, made from its declaration.
#pragma once
#include <map>
#include <set>
#include <string>

#include "common/app/knob.h"

namespace lightwalk {

/// Knobs by their paths.
struct AutoChoices {
    struct Chosen {
        std::string method;  ///< it stays chosen as long as the knob has this value
        std::string line;    ///< which and why, or why not
    };
    std::set<std::string> offered;  ///< the ones compared by a study
    std::set<std::string> without;  ///< methods that none compares
    std::map<std::string, Chosen> chosen;
    float budget = 0.01f;  ///< greatest mean FLIP allowed
    std::string wanted;    ///< asked for by a click and not measured yet; empty: none
    int asked_at = 0;      ///< frames that were drawn before

    bool holds(const std::string& path, const std::string& method) const {
        const auto found = chosen.find(path);
        return found != chosen.end() && found->second.method == method;
    }
};

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
