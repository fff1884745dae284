// Flicker of a picture while the camera walks: standard deviation of the luminance error over time.
#pragma once
#include <map>

#include "common/app/chapter.h"
#include "common/image/image.h"

namespace lightwalk {

/// Of a chapter whose `method` has the option "none" and whose eye walks by `walk_m_s` and the frame's time; where
/// `remake` is off it keeps the levels that it has.
class Flicker : public Module {
  public:
    using Module::Module;

    struct Knobs {
        Choice& method;
        Knob<float>& walk_m_s;
        Knob<bool>& remake;
    };
    static constexpr int pictures = 6;       ///< one every 1/60 s
    static constexpr float pace_m_s = 1.5f;  ///< of who walks
    static constexpr int truth_samples = 16;

    /// The mean over pixels of the standard deviation, over the pictures, of how far a pixel's luminance is from that
    /// of a picture of the same moment without levels and with many samples a pixel. What moves because the eye does is
    /// in both and counts as nothing. Linear light, clamped to 1. Sets knobs, and leaves it to the caller to put them
    /// back.
    double measure(Chapter& chapter, Gpu& gpu, glm::uvec2 size, const Knobs& knobs);

    /// The pictures of the truth are kept for a scene.
    void prepare(Gpu&, Scene&) override { truth_.clear(); }

  private:
    std::map<std::pair<uint32_t, uint32_t>, std::vector<ImageRgb>> truth_;  ///< by size
};

}  // namespace lightwalk
