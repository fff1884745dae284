#include "common/check/choice.h"

#include <fmt/core.h>

namespace lightwalk {
namespace {

ErrorAndCost measured(const ChoiceTask& choice, const ChoiceScene& scene, const Row& chosen) {
    std::vector<int> knobs;
    for (size_t i = 0; i < choice.knobs.size(); ++i) {
        const auto& [name, lowest, highest] = choice.knobs[i];
        if (chosen[i] < lowest || chosen[i] > highest)
            return {.unusable = fmt::format("{} is {} to {}", name, lowest, highest)};
        knobs.push_back(int(chosen[i]));
    }
    return scene.measure(knobs);
}

}  // namespace

void check_choice(Check& check, const ChoiceTask& choice) {
    Probe probe{.include = choice.include, .signature = choice.signature};
    for (size_t i = 0; i < choice.scenes.size(); ++i) probe.inputs.push_back({double(i)});
    const Table chosen = run_probe(check_device(), probe, choice.knobs.size());
    for (size_t i = 0; i < choice.scenes.size(); ++i) {
        const ChoiceScene& scene = choice.scenes[i];
        const ErrorAndCost found = measured(choice, scene, chosen[i]);
        const std::string gave = fmt::format("{} gave {} for {}: ", call_text(probe, probe.inputs[i]),
                                             result_text(probe, chosen[i]), scene.name);
        if (!found.unusable.empty()) {
            check.expect(false, gave + found.unusable);
            continue;
        }
        const std::string figures = fmt::format("an error of {:.3g}{} ({:.3g}{} allowed), {:.4g} of at most {:.4g} {}",
                                                found.error, choice.error_unit, scene.most_error, choice.error_unit,
                                                found.cost, scene.most_cost, choice.cost_unit);
        const bool exact = found.error <= scene.most_error, cheap = found.cost <= scene.most_cost;
        check.expect(exact && cheap, gave + figures,
                     cheap   ? "The cost is within its limit, the error is not: what would the same cost buy elsewhere?"
                     : exact ? "It is exact enough, and costs too much: which method needs less for the same?"
                             : "Neither is within its limit: another method suits this one.");
        check.note += (check.note.empty() ? "" : "; ") + scene.name + ": " + figures;
    }
}

}  // namespace lightwalk
