#include "common/study/knob_values.h"

#include <algorithm>

namespace lightwalk {

void set_knobs(const KnobList& knobs, const KnobValues& values) {
    for (const auto& [name, value] : values) find_knob(knobs, name).set(value);
}

bool have_values(const KnobList& knobs, const KnobValues& values) {
    const KeptKnobs kept(knobs);
    return std::all_of(values.begin(), values.end(), [&](const auto& wanted) {
        KnobBase& knob = find_knob(knobs, wanted.first);
        const std::string now = knob.text();
        knob.set(wanted.second);
        return knob.text() == now;
    });
}

nlohmann::json as_json(const KnobValues& values) {
    using nlohmann::json;
    json knobs = json::object();
    for (const auto& [name, value] : values) {
        const json number = json::parse(value, nullptr, false);
        knobs[name] = number.is_number() ? number : json(value);
    }
    return knobs;
}

KeptKnobs::KeptKnobs(const KnobList& knobs) {
    for (KnobBase* knob : knobs) kept_.emplace_back(knob, knob->text());
}

void KeptKnobs::put_back() const {
    for (const auto& [knob, text] : kept_) knob->set(text);
}

}  // namespace lightwalk
