#include "common/window/window_picture.h"

#include <optional>
#include <utility>

#include "common/window/activity.h"
#include "common/window/blit.h"

namespace lightwalk {
namespace {

constexpr double compare_every_s = 1.0;  // while the picture moves

}  // namespace

void WindowPicture::draw(glm::uvec2 size, float time_s, const std::function<void(Capture&)>& captured) {
    Chapter& chapter = live_.chapter;
    refined = 0;
    size_ = size;
    shown_ = nullptr;
    compared_ = false;
    gpu_.pipelines.errors.clear();
    look.attach(frame_, viewed_, chapter.camera, chapter.scene.bounds);
    graph.attach(frame_, chapter.camera, chapter.scene.bounds);
    const Picture picture{.size = size, .time_s = time_s, .seed = seed_, .crop = {}, .gathered = 0};
    {
        // Where every switch says reference, two equal halves would show nothing: the left one is then mine.
        const auto own = own_exercises(chapter);
        std::optional<ToggleScope> mine;
        if (split.on() && all_reference(own)) mine.emplace(own, false);
        std::optional<Capture> capture;
        if (captured) {
            frame_.set_frames_in_flight(1);
            capture.emplace();
        }
        live_.draw(frame_, picture);
        if (capture) captured(*capture);
    }
    if (split.on()) split.draw(chapter, look, picture);
}

bool WindowPicture::can_refine() const {
    return refined < most_samples && !split.on() && look.output.empty() && live_.chapter.samples == 1 &&
           !live_.chapter.any_animated();
}

void WindowPicture::refine(float time_s) {
    live_.draw(frame_, {size_, time_s, seed_, {}, glm::ivec2(refined++, most_samples)});
}

const Image& WindowPicture::show(Frame& screen) {
    shown_ = &mine();
    if (!split.on()) return *shown_;
    const Image& reference = split.picture(look);
    if (composed_.desc.size != size_ || !composed_)
        composed_ = Image(gpu_.device, {.name = "composed", .format = VK_FORMAT_R8G8B8A8_UNORM, .size = size_});
    const uint32_t left = std::min(static_cast<uint32_t>(split.divider * static_cast<float>(size_.x)), size_.x);
    screen.transfer("compose", {.reads = {*shown_, reference}, .writes = {composed_}}, [&](VkCommandBuffer commands) {
        const Area left_side{{0, 0}, {left, size_.y}}, right_side{{left, 0}, {size_.x - left, size_.y}};
        blit(commands, mine(), left_side, composed_, left_side);
        blit(commands, reference, right_side, composed_, right_side);
    });
    shown_ = &composed_;
    return *shown_;
}

bool WindowPicture::compare(bool still, bool moves) {
    if (!split.drawn() || !frame_.output) return false;
    const bool has_come = split.poll();
    if (!compared_ && (still || (moves && steady_s() > next_compare_s_))) {
        split.compare(mine(), split.picture(look));
        next_compare_s_ = steady_s() + compare_every_s;
        compared_ = true;
    }
    return has_come;
}

}  // namespace lightwalk
