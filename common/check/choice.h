// Exercises that choose a method and its knobs for a scene: the check measures error and cost, both against limits.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "common/check/check.h"

namespace lightwalk {

/// Figures of one scene's choice.
struct Weighed {
    double error = 0;
    double cost = 0;       ///< counted: reads, samples, bytes
    std::string unusable;  ///< "a size is 512 or 1024"; empty if it can be measured
};

/// A number of the choice, with its range.
struct ChosenKnob {
    std::string name;
    int lowest, highest;
};

struct ChoiceScene {
    std::string name;  ///< "the grooves"
    double most_error, most_cost;
    std::function<Weighed(std::span<const int> knobs)> measure;  ///< in their ranges
};

struct ChoiceTask {
    std::string include, signature;  ///< as a Probe's; the argument is the scene's number
    std::vector<ChosenKnob> knobs;   ///< of the result
    std::string error_unit;          ///< "%" or " pixels"
    std::string cost_unit;           ///< "reads"
    std::vector<ChoiceScene> scenes;
};

/// Expects both figures of every scene within their limits; the note states all of them.
void weigh(Check& check, const ChoiceTask& choice);

}  // namespace lightwalk
