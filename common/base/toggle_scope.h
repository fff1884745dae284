// Temporary exercise toggles.
#pragma once
#include <string>
#include <vector>

namespace lightwalk {

class ToggleScope {
  public:
    /// Selects the solution, if there is one, or the student's version; restores on destruction.
    ToggleScope(const std::vector<std::string>& ids, bool solution);
    ~ToggleScope();
    ToggleScope(const ToggleScope&) = delete;

    bool changed() const { return !changed_.empty(); }

  private:
    std::vector<std::string> changed_;
    bool solution_;
};

}  // namespace lightwalk
