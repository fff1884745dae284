// Flicker of a picture while the camera walks: standard deviation of the luminance error over time.
#pragma once
#include <algorithm>
#include <cmath>
#include <map>

#include "common/app/read_picture.h"
#include "common/app/render.h"
#include "common/image/luminance.h"

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
    double measure(Chapter& chapter, Gpu& gpu, glm::uvec2 size, const Knobs& knobs) {
        knobs.walk_m_s.value = pace_m_s;
        knobs.remake.value = false;
        const std::vector<ImageRgb> found = walk(chapter, gpu, size);
        std::vector<ImageRgb>& truth = truth_[{size.x, size.y}];
        if (truth.empty()) {
            knobs.method.set("none");
            chapter.samples.value = truth_samples;
            truth = walk(chapter, gpu, size);
        }
        const auto shown = [](const glm::vec3& color) {
            return luminance(glm::dvec3(glm::min(color, glm::vec3(1.0f))));
        };
        double sum = 0;
        for (size_t p = 0; p < found[0].pixels.size(); ++p) {
            double mean = 0, square = 0;
            for (int i = 0; i < pictures; ++i) {
                const double off = shown(found[size_t(i)].pixels[p]) - shown(truth[size_t(i)].pixels[p]);
                mean += off / pictures;
                square += off * off / pictures;
            }
            sum += std::sqrt(std::max(square - mean * mean, 0.0));
        }
        return sum / static_cast<double>(found[0].pixels.size());
    }

    /// The pictures of the truth are kept for a scene.
    void prepare(Gpu&, Scene&) override { truth_.clear(); }

  private:
    static std::vector<ImageRgb> walk(Chapter& chapter, Gpu& gpu, glm::uvec2 size) {
        std::vector<ImageRgb> walked;
        Frame frame(gpu);
        for (int i = 0; i < pictures; ++i) {
            render(chapter, frame, {size, static_cast<float>(i) / 60.0f, 0, {}});
            walked.push_back(read_linear(gpu, frame.linear()));
        }
        return walked;
    }

    std::map<std::pair<uint32_t, uint32_t>, std::vector<ImageRgb>> truth_;  ///< by size
};

}  // namespace lightwalk
