// Opens the lessons' pages, made by ./course docs, in the system's browser.
#pragma once
#include <memory>
#include <string>

#include "common/window/child_process.h"

namespace lightwalk {

class LessonPages {
  public:
    /// Shows the page of a chapter ("02_lambert_phong"), or of an exercise ("02.phong") at its heading. Returns a
    /// message: that it opens, or the missing part.
    std::string open(const std::string& name);

    /// The failure since the last call; empty: none.
    std::string poll();

  private:
    std::string page_;
    std::unique_ptr<ChildProcess> opener_;
};

/// The first heading of docs/NN_name.md without a leading "Chapter NN:"; where there is none, the name in words.
std::string chapter_title(const std::string& chapter);

}  // namespace lightwalk
