// Chapters that ./course run is still building while the menu is open (common/course/run.py).
#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace lightwalk {

/// A chapter's program: whether it can be started, and how far its build is.
struct ProgramState {
    std::string name = "ready";  ///< or waiting, building, failed
    int done = 0, total = 0;     ///< steps of a chapter that is being built
    bool operator==(const ProgramState&) const = default;
};

class MenuPrograms {
  public:
    /// A folder through which the build and the menu talk; "": all chapters are built.
    explicit MenuPrograms(std::filesystem::path folder);

    /// Reads the states again. True if one has changed.
    bool poll();

    /// Whether some chapter is not ready.
    bool are_building() const;

    const std::map<std::string, ProgramState>& states() const { return states_; }
    ProgramState state(const std::string& chapter) const;

    /// Asks for a chapter to be built before the others.
    void want(const std::string& chapter);
    const std::string& wanted() const { return wanted_; }

  private:
    std::filesystem::path folder_;
    std::map<std::string, ProgramState> states_;
    std::string wanted_;
};

}  // namespace lightwalk
