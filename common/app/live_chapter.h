// A chapter while someone works on it: what fails is said, and what worked last stays.
#pragma once
#include "common/app/chapter.h"

namespace lightwalk {

class LiveChapter {
  public:
    LiveChapter(Chapter& chapter, Gpu& gpu, std::filesystem::path scene);

    Chapter& chapter;

    /// The scene for the first time. Throws InputError; but where a student's loader is in use and fails, the reference
    /// loads the scene and load_error says so.
    void load();

    /// The scene again, as the toggles say. Camera and knobs stay; where it fails, so does the old scene.
    void reload();

    /// Records and submits a frame. Loads the scene anew first where toggles or knobs change how it is loaded.
    void draw(Frame& frame, glm::uvec2 size, float time_s, unsigned seed);

    std::string load_error;   ///< of the last load; empty: it went well
    std::string frame_error;  ///< of the last frame

  private:
    std::string key() const;  ///< of what loading depends on
    Gpu& gpu_;
    std::filesystem::path scene_;
    std::string loaded_with_;
};

/// Sets toggles for as long as it lives.
class ToggleScope {
  public:
    /// Every exercise to the reference or to the student's version.
    explicit ToggleScope(bool solution);
    ~ToggleScope();
    ToggleScope(const ToggleScope&) = delete;

  private:
    std::vector<std::pair<std::string, bool>> before_;
};

/// The exercises a chapter can use: its own and earlier ones, its own first.
std::vector<std::string> exercises_of(const Chapter& chapter);

}  // namespace lightwalk
