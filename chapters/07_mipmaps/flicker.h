// Flicker of a picture while the camera walks: standard deviation of the luminance error over time.
#pragma once
#include <map>

#include "common/app/chapter.h"
#include "common/image/image.h"

namespace lightwalk {

/// For a chapter with the method "none" and a camera that walks by `walk_m_s`; with `remake` off it keeps its levels.
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

    /// Mean over pixels of the standard deviation over time of a pixel's luminance error, against pictures without
    /// levels and with many samples, so that the camera's own motion does not count. Linear light, clamped to 1. Sets
    /// knobs; the caller restores them.
    double measure(Chapter& chapter, Gpu& gpu, glm::uvec2 size, const Knobs& knobs);

    /// The pictures of the truth are kept for a scene.
    void prepare(Gpu&, Scene&) override { truth_.clear(); }

  private:
    std::map<std::pair<uint32_t, uint32_t>, std::vector<ImageRgb>> truth_;  ///< by size
};

}  // namespace lightwalk
