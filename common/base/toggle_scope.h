// Toggles of exercises, set for a while.
#pragma once
#include <string>
#include <vector>

namespace lightwalk {

/// Sets toggles during its lifetime and restores them afterwards.
class ToggleScope {
  public:
    /// These exercises to the reference, where there is one, or to the student's version.
    ToggleScope(const std::vector<std::string>& ids, bool solution);
    ~ToggleScope();
    ToggleScope(const ToggleScope&) = delete;

    /// True if one of them was the other version before.
    bool changed() const { return !changed_.empty(); }

  private:
    std::vector<std::string> changed_;
    bool solution_;
};

}  // namespace lightwalk
