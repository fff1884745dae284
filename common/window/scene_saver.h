// Ctrl+S of a window: the camera and the knobs, in a scene file.
#pragma once
#include <filesystem>

#include "common/app/chapter.h"
#include "common/window/activity.h"

namespace lightwalk {

class SceneSaver {
  public:
    SceneSaver(const Chapter& chapter, std::filesystem::path scene, Notice& notice);

    /// Saves a person's scene file and preserves the rest of it; if it changed since it was read, or another file
    /// exists there, the key must be pressed twice.
    void save();
    void remember();  ///< the file was read again

  private:
    const Chapter& chapter_;
    std::filesystem::path scene_;
    Notice& notice_;
    uint64_t read_ = 0;         ///< hash of the scene file as it was read or saved
    uint64_t saved_ = 0;        ///< of the file that was saved beside it
    double confirm_until_ = 0;  ///< until then it is saved without asking
};

}  // namespace lightwalk
