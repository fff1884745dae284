// The lessons' pages, which ./course docs makes, in whatever shows web pages here.
#pragma once
#include <memory>
#include <string>

#include "common/window/child_process.h"

namespace lightwalk {

class LessonPages {
  public:
    /// Shows the page of a chapter ("02_lambert_phong") or of an exercise ("02.phong"), at its heading. Returns what
    /// the person should know: that it opens, or what is missing.
    std::string open(const std::string& name);

    /// What went wrong since, once; empty where nothing did.
    std::string poll();

  private:
    std::string page_;
    std::unique_ptr<ChildProcess> opener_;
};

}  // namespace lightwalk
