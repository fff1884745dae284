// A chapter during editing: failures are reported, and the last working version stays.
#pragma once
#include "common/app/render.h"
#include "common/base/toggle_scope.h"

namespace lightwalk {

class LiveChapter {
  public:
    LiveChapter(Chapter& chapter, Gpu& gpu, std::filesystem::path scene);

    Chapter& chapter;

    /// The scene for the first time. Throws InputError; but where a student's loader is in use and fails, the reference
    /// loads the scene and load_error says so.
    void load(const Loading& loading = {});

    /// The scene again, as the toggles say. Camera and knobs stay; where it fails, so does the old scene.
    void reload();

    /// Reloads the scene if changed toggles or knobs affect loading.
    void follow_toggles() {
        if (loaded_with_ != chapter.load_state()) reload();
    }

    /// Records and submits a frame. Reloads the scene first if toggles or knobs affect loading.
    void draw(Frame& frame, const Picture& picture);

    std::string load_error;   ///< of the last load; empty: it went well
    std::string frame_error;  ///< of the last frame

  private:
    Gpu& gpu_;
    std::filesystem::path scene_;
    std::string loaded_with_;
};

/// The chapter's own exercises, and those of earlier chapters it uses.
std::vector<std::string> own_exercises(const Chapter& chapter);
std::vector<std::string> earlier_exercises(const Chapter& chapter);

/// True if all of them use the reference, or there are none.
bool all_reference(const std::vector<std::string>& ids);

/// True if a reference exists for one of them: not in a handout.
bool any_reference_exists(const std::vector<std::string>& ids);

}  // namespace lightwalk
