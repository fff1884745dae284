// Checks of exercises that choose method parameters per scene: error and cost have limits.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "common/check/check.h"

namespace lightwalk {

/// Measured result of one scene.
struct ErrorAndCost {
    double error = 0;
    double cost = 0;       ///< counts of reads, samples or bytes
    std::string unusable;  ///< reason why it cannot be measured; empty: measured
};

struct ChosenKnob {
    std::string name;
    int lowest, highest;
};

struct ChoiceScene {
    std::string name;
    double most_error, most_cost;
    std::function<ErrorAndCost(std::span<const int> knobs)> measure;
};

struct ChoiceTask {
    std::string include, signature;  ///< file and signature, as in Probe; the argument is the scene's index
    std::vector<ChosenKnob> knobs;
    std::string error_unit;
    std::string cost_unit;
    std::vector<ChoiceScene> scenes;
};

/// Expects error and cost of every scene within limits; the note lists all figures.
void check_choice(Check& check, const ChoiceTask& choice);

}  // namespace lightwalk
