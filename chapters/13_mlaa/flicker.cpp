#include "13_mlaa/flicker.h"

#include "13_mlaa/edge_error.h"
#include "common/app/read_picture.h"
#include "common/app/render.h"

namespace lightwalk {

double flicker_of(const std::vector<ImageRgb>& found, const std::vector<ImageRgb>& truth) {
    double sum = 0, count = 0;
    for (size_t i = 1; i < found.size(); ++i)
        for (size_t p = 0; p < found[i].pixels.size(); ++p) {
            const glm::vec3 off =
                glm::abs((found[i].pixels[p] - found[i - 1].pixels[p]) - (truth[i].pixels[p] - truth[i - 1].pixels[p]));
            sum += double(off.r + off.g + off.b) / 3;
            ++count;
        }
    return count > 0 ? sum / count : 0;
}

double Flicker::measure(Chapter& chapter, Mlaa& antialias, Gpu& gpu, glm::uvec2 size) {
    const glm::uvec2 part = glm::max(size / 4u, 1u);
    const auto draw = [&](int samples) {
        chapter.samples.value = samples;
        Frame frame(gpu);
        std::vector<ImageRgb> pictures;
        Picture picture{.size = part, .crop = {.whole = size, .origin = (size - part) / 2u}};
        for (int i = 0; i < frames; ++i) {
            picture.time_s = static_cast<float>(i) / 60.0f;
            render(chapter, frame, picture);
            picture.gathered = 0;  // it goes on
            pictures.push_back(read_linear(gpu, frame.linear()));
        }
        return pictures;
    };
    const std::vector<ImageRgb> found = draw(1);
    antialias.method.set("none");
    std::vector<ImageRgb>& truth = known_[drawn_with(chapter, antialias, size)];
    if (truth.empty()) truth = draw(truth_samples);
    return flicker_of(found, truth);
}

}  // namespace lightwalk
