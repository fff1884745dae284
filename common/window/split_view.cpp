#include "common/window/split_view.h"

#include <chrono>

#include "common/app/read_picture.h"
#include "common/base/exercise.h"
#include "common/base/files.h"
#include "common/measure/flip.h"

namespace lightwalk {
namespace {

constexpr int greatest_compared_width = 640;

// Mean of blocks of `shrink` × `shrink` pixels, in linear light; partial blocks at the edges are dropped.
ImageRgb shrunk(const ImageRgb& image, int shrink) {
    ImageRgb result(std::max(image.width / shrink, 1), std::max(image.height / shrink, 1));
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            glm::vec3 sum(0.0f);
            for (int dy = 0; dy < shrink; ++dy)
                for (int dx = 0; dx < shrink; ++dx)
                    sum += image.at(std::min(x * shrink + dx, image.width - 1),
                                    std::min(y * shrink + dy, image.height - 1));
            result.at(x, y) = sum / static_cast<float>(shrink * shrink);
        }
    return result;
}

PictureDifference compare_pictures(const Image8& mine, const Image8& reference) {
    const int shrink = (mine.width + greatest_compared_width - 1) / greatest_compared_width;
    const auto prepared = [&](const Image8& image) { return shrunk(to_linear(image), shrink); };
    const float pixels_per_degree = default_pixels_per_degree / static_cast<float>(shrink);
    const ErrorMap map = flip_ldr(prepared(reference), prepared(mine), pixels_per_degree);
    return {summarize(map).mean, shrink};
}

uint64_t hash(const Image8& image, uint64_t seed) {
    return hash_bytes(
        {reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size() * sizeof image.pixels[0]}, seed);
}

}  // namespace

SplitView::SplitView(Gpu& gpu, const MakeChapter& make, std::filesystem::path scene)
    : gpu_(gpu), make_(make), scene_(std::move(scene)) {}

void SplitView::turn_on(const Chapter& chapter) {
    auto made = make_();
    made->name = chapter.name;
    auto live = std::make_unique<LiveChapter>(*made, gpu_, scene_);
    const ToggleScope reference(Exercises::ids(), true);
    live->load();
    chapter_ = std::move(made);
    live_ = std::move(live);
    frame_ = std::make_unique<Frame>(gpu_);
    difference.reset();
}

void SplitView::turn_off() {
    frame_.reset();
    live_.reset();
    chapter_.reset();
    difference.reset();
}

void SplitView::reload() {
    if (!on()) return;
    const ToggleScope reference(Exercises::ids(), true);
    live_->reload();
}

void SplitView::draw(const Chapter& chapter, const Look& look, const Picture& picture) {
    const KnobList from = chapter.all_knobs(), to = chapter_->all_knobs();
    for (size_t i = 0; i < from.size(); ++i) to[i]->set(from[i]->text());
    chapter_->camera = chapter.camera;
    look.attach(*frame_, viewed_, chapter_->camera, chapter_->scene.bounds);
    const ToggleScope reference(Exercises::ids(), true);
    live_->draw(*frame_, picture);
}

std::string SplitView::error() const {
    if (!live_) return {};
    const std::string& why = live_->load_error.empty() ? live_->frame_error : live_->load_error;
    return why.empty() ? why : "reference: " + why;
}

void SplitView::compare(const Image& mine, const Image& reference) {
    if (running_.valid()) return;
    Image8 left = read_picture(gpu_, mine), right = read_picture(gpu_, reference);
    const uint64_t pictures = hash(right, hash(left, 1));
    if (pictures == compared_ && difference) return;
    compared_ = pictures;
    difference.reset();
    // Where no thread can be started, poll() compares them.
    running_ = std::async([left = std::move(left), right = std::move(right)] { return compare_pictures(left, right); });
}

bool SplitView::poll() {
    if (!running_.valid() || running_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) return false;
    const PictureDifference result = running_.get();
    if (on()) difference = result;
    return on();
}

}  // namespace lightwalk
