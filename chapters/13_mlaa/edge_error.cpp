#include "13_mlaa/edge_error.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "common/app/read_picture.h"
#include "common/app/render.h"

namespace lightwalk {

EdgePixels compare_edges(const ImageRgb& found, const ImageRgb& one_sample, const ImageRgb& truth) {
    EdgePixels result;
    double count = 0, square = 0;
    for (size_t i = 0; i < truth.pixels.size(); ++i) {
        const glm::vec3 moved = glm::abs(truth.pixels[i] - one_sample.pixels[i]);
        const glm::dvec3 off = glm::dvec3(found.pixels[i]) - glm::dvec3(truth.pixels[i]);
        if (glm::max(glm::max(moved.r, moved.g), moved.b) > 1.0f / 64) {
            ++count;
            square += glm::dot(off, off) / 3;
        } else
            for (int c = 0; c < 3; ++c)
                result.off_edges =
                    std::max(result.off_edges, 255 * double(std::abs(found.pixels[i][c] - one_sample.pixels[i][c])));
    }
    result.rmse = count > 0 ? std::sqrt(square / count) : 0;
    result.share = count / double(truth.pixels.size());
    return result;
}

std::string drawn_with(const Chapter& chapter, const Mlaa& antialias, glm::uvec2 size) {
    std::string key = fmt::format("{}x{} {}", size.x, size.y, chapter.scene.file.file.string());
    for (const KnobBase* knob : chapter.all_knobs())
        if (&knob->owner != &antialias && &knob->owner != &antialias.taa && knob != &chapter.samples)
            key += " " + knob->path() + "=" + knob->text();
    return key;
}

void EdgeError::measure(Chapter& chapter, Mlaa& antialias, Gpu& gpu, glm::uvec2 size, nlohmann::json& error) {
    const auto draw = [&](int samples) {
        chapter.samples.value = samples;
        Frame frame(gpu);
        render(chapter, frame, {size, 0.0f, 0, {}});
        return read_linear(gpu, frame.linear());
    };
    antialias.count.value = true;
    const ImageRgb found = draw(1);
    antialias.count.value = false;
    const double pixels = double(size.x) * size.y;
    error["mixed"] = antialias.is_filter() ? antialias.counts().changed / pixels : 0;

    antialias.method.set("none");
    Pair& pair = known_[drawn_with(chapter, antialias, size)];
    if (pair.truth.pixels.empty()) pair = {draw(1), draw(64)};
    error["edge_rmse"] = compare_edges(found, pair.one_sample, pair.truth).rmse;
}

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
