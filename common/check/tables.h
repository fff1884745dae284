// Probe data as JSON, for checks in the browser.
#pragma once
#include <nlohmann/json.hpp>

#include "common/check/check.h"

namespace lightwalk {

class ProbeTables {
  public:
    explicit ProbeTables(std::string exercise) : exercise_(std::move(exercise)) {}
    void add(const Probe& probe, const Table& results);
    /// Counts an expectation that bounds cannot express.
    void add_other() { ++others_; }
    /// {"exercise", "hint", "probes": [...], "others"}. With `others` above 0, a page cannot reach the full verdict.
    nlohmann::ordered_json json(const ExerciseCheck& exercise, const Check& check) const;

  private:
    std::string exercise_;
    int rows_ = 0, others_ = 0;
    nlohmann::ordered_json probes_ = nlohmann::ordered_json::array();
};

/// Runs the check on the solution and writes `folder`/NN.name.json, if it has probes.
void write_tables(const ExerciseCheck& exercise, const std::string& folder);
/// Writes `folder`/undefined.json: {"glsl", "words": [[what, text], ...], "results"}.
void write_undefined(const std::string& folder);

}  // namespace lightwalk
