// Titles over the picture, in an alphabet of strokes.
#pragma once
#include "19_ambiance/stroke.h"
#include "19_ambiance/timeline.h"
#include "common/app/module.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// The strokes of a text in one line, from (0, 0) to the right; capitals are 1 high. Small letters are drawn as capitals;
/// what the alphabet lacks is a gap. `width`: where the next letter would stand.
std::vector<Stroke> strokes_of(const std::string& text, float& width);

/// Draws what a film's titles say at a time over the picture of RGBA16F, 0 to 1 in linear light.
class Titles {
  public:
    void record(Frame& frame, const Image& picture, const Timeline& film, double time_s);

  private:
    Buffer strokes_;
    Pipeline draw_ = compute({.shader = "19_ambiance/title.comp"});
};

}  // namespace lightwalk
