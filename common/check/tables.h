// Tables of checks: a probe's inputs, truths and hints as JSON, for a page that runs it in a browser.
#pragma once
#include <nlohmann/json.hpp>

#include "common/check/check.h"

namespace lightwalk {

/// The probes of one exercise's check, collected while the check runs on the reference.
class ProbeTables {
  public:
    explicit ProbeTables(std::string exercise) : exercise_(std::move(exercise)) {}
    void add(const Probe& probe, const Table& results);
    /// A property that results within the bounds need not have.
    void add_other() { ++others_; }
    /// One exercise: {"exercise", "hint", "probes": [...], "others"}. `others` counts expectations that the probes do not
    /// contain: where it is above 0 a page cannot reach the same verdict.
    nlohmann::ordered_json json(const ExerciseCheck& exercise, const Check& check) const;

  private:
    std::string exercise_;
    int rows_ = 0, others_ = 0;
    nlohmann::ordered_json probes_ = nlohmann::ordered_json::array();
};

/// Runs the check on the reference, and writes `folder`/NN.name.json; nothing for an exercise without a probe.
void write_tables(const ExerciseCheck& exercise, const std::string& folder);
/// Data that finds undefined operations: {"glsl", "words": [[what, text], ...], "results"}, as
/// `folder`/undefined.json.
void write_undefined(const std::string& folder);

}  // namespace lightwalk
