#include "07_mipmaps/flicker.h"

#include <algorithm>
#include <cmath>

#include "common/app/read_picture.h"
#include "common/app/render.h"
#include "common/image/luminance.h"

namespace lightwalk {
namespace {

std::vector<ImageRgb> walk(Chapter& chapter, Gpu& gpu, glm::uvec2 size) {
    std::vector<ImageRgb> pictures;
    Frame frame(gpu);
    for (int i = 0; i < Flicker::pictures; ++i) {
        render(chapter, frame, {size, static_cast<float>(i) / 60.0f, 0, {}});
        pictures.push_back(read_linear(gpu, frame.linear()));
    }
    return pictures;
}

double shown(const glm::vec3& color) { return luminance(glm::dvec3(glm::min(color, glm::vec3(1.0f)))); }

}  // namespace

double Flicker::measure(Chapter& chapter, Gpu& gpu, glm::uvec2 size, const Knobs& knobs) {
    knobs.walk_m_s.value = pace_m_s;
    knobs.remake.value = false;
    const std::vector<ImageRgb> found = walk(chapter, gpu, size);
    std::vector<ImageRgb>& truth = truth_[{size.x, size.y}];
    if (truth.empty()) {
        knobs.method.set("none");
        chapter.samples.value = truth_samples;
        truth = walk(chapter, gpu, size);
    }
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

}  // namespace lightwalk
