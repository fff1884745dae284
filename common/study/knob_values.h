// Values of knobs as a study keeps them: set, compared, put back.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "common/app/knob.h"

namespace lightwalk {

/// Knobs by name, each with the text that KnobBase::set takes.
using KnobValues = std::vector<std::pair<std::string, std::string>>;

void set_knobs(const KnobList& knobs, const KnobValues& values);

/// Whether the knobs have these values, in any notation.
bool have_values(const KnobList& knobs, const KnobValues& values);

/// As JSON has them: a number where it is one.
nlohmann::json as_json(const KnobValues& values);

/// Restores every knob to its value at construction.
class KeptKnobs {
  public:
    explicit KeptKnobs(const KnobList& knobs);
    ~KeptKnobs() { put_back(); }
    KeptKnobs(const KeptKnobs&) = delete;
    void put_back() const;

  private:
    std::vector<std::pair<KnobBase*, std::string>> kept_;
};

}  // namespace lightwalk
