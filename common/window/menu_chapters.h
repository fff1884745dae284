// Chapters of the menu: programs, titles and pictures.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "common/gpu/gpu.h"

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

struct MenuEntry {
    std::string chapter, title;
    std::filesystem::path program;
    Image picture;  ///< none if nothing has been drawn yet
};

/// Chapters that are built or being built beside this program, in order. `scale`: of the display.
std::vector<MenuEntry> find_chapters(Gpu& gpu, float scale, const MenuPrograms& programs);

}  // namespace lightwalk
