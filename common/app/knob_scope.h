// A knob that is set for a while.
#pragma once
#include "common/app/knob.h"

namespace lightwalk {

/// Sets a knob while it lives, and then restores the value that it had.
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
