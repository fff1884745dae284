// Knob value set within a scope.
#pragma once
#include "common/app/knob.h"

namespace lightwalk {

class KnobScope {
  public:
    KnobScope(KnobBase& knob, const std::string& value) : knob_(knob), before_(knob.text()) { knob_.set(value); }
    ~KnobScope() { knob_.set(before_); }
    KnobScope(const KnobScope&) = delete;

  private:
    KnobBase& knob_;
    const std::string before_;
};

}  // namespace lightwalk
