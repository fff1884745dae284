// Titles over the picture.
#pragma once
#include "19_ambiance/timeline.h"
#include "19_ambiance/typeface.h"
#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// Draws what a film's titles say at a time over the picture of RGBA16F, 0 to 1 in linear light.
class Titles {
  public:
    void record(Frame& frame, const Image& picture, const Timeline& film, double time_s);

    /// Reads the typeface, if the film has titles: no frame waits for it.
    void prepare(Gpu& gpu, const Timeline& film) {
        if (!film.titles.empty()) face_.load(gpu);
    }

  private:
    Typeface face_;
    Buffer glyphs_;
    Fingerprint glyphs_made_;
    Pipeline draw_ = compute({.shader = "19_ambiance/title.comp"});
};

}  // namespace lightwalk
