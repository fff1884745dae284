#include "common/window/window_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "common/app/read_picture.h"
#include "common/base/text.h"
#include "common/gpu/barrier.h"
#include "common/scene/pick.h"
#include "common/window/activity.h"
#include "common/window/blit.h"
#include "common/window/event_log.h"

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

namespace {

constexpr size_t most_triangles = 2'000'000;  // more of them take longer than the mouse may wait

std::vector<std::byte> read_texel(Gpu& gpu, const ImageView& view, glm::uvec2 at, VkDeviceSize bytes) {
    Buffer staging(gpu.device, {.name = "pixel", .bytes = bytes, .host_visible = true});
    const VkBufferImageCopy texel{.imageSubresource = view.first_mip_layers(),
                                  .imageOffset = {static_cast<int>(at.x), static_cast<int>(at.y), 0},
                                  .imageExtent = {1, 1, 1}};
    gpu.submit_now([&](VkCommandBuffer commands) {
        barrier(commands, view.mip(0), transfer_read);
        barrier(commands, staging, transfer_write);
        vkCmdCopyImageToBuffer(commands, view.image->handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, staging.handle, 1,
                               &texel);
        barrier(commands, staging, host_read);
    });
    return {staging.mapped, staging.mapped + bytes};
}

bool wrote(const Frame& frame, const Image& image) {
    return std::any_of(frame.outputs.begin(), frame.outputs.end(),
                       [&](const auto& output) { return output.second.image == &image; });
}

// A frame is drawn in halves, the mean of several in floats.
std::string value_words(Gpu& gpu, const Image& linear, glm::uvec2 at) {
    const glm::vec4 value =
        texel_value(linear.desc.format, read_texel(gpu, linear, at, texel_bytes(linear.desc.format)));
    return fmt::format("{:.3g} {:.3g} {:.3g}", value.r, value.g, value.b);
}

// Metres along the direction of view; the depth of a chapter's camera.
std::string depth_words(Gpu& gpu, const Image& depth, const ViewRays& rays, glm::uvec2 at) {
    float value = 0.0f;
    std::memcpy(&value, read_texel(gpu, depth, at, sizeof value).data(), sizeof value);
    return value > 0.0f ? fmt::format("{:.4g} m", distance_along_view(rays, value)) : "";
}

std::string name_of(const SceneObject& object) {
    return printable(object.name.empty() ? object.model.filename().string() : object.name);
}

}  // namespace

void PixelProbe::look(Gpu& gpu, const Frame& frame, const Chapter& chapter, std::optional<glm::uvec2> at) {
    if (at && glm::any(glm::greaterThanEqual(*at, frame.size))) at.reset();
    const double now_s = steady_s();
    if (at == at_ && (frame.output.written_in == frame_ || now_s < next_s_)) return;
    next_s_ = now_s + 0.1;  // of a picture that moves
    at_ = at;
    frame_ = frame.output.written_in;
    words_.clear();
    if (!at) return;
    words_.push_back(fmt::format("{}, {}", at->x, at->y));
    if (wrote(frame, frame.hdr)) words_.push_back(value_words(gpu, frame.linear(), *at));
    const ViewRays rays = view_rays(camera_view(chapter.camera, glm::mat4(1.0f), frame.size));
    const std::string depth = wrote(frame, frame.depth) ? depth_words(gpu, frame.depth, rays, *at) : "";
    if (!depth.empty()) words_.push_back(depth);
    const PickRay ray{rays.eye, glm::normalize(ray_through(rays, glm::vec2(*at) + 0.5f))};
    const bool names = !depth.empty() && chapter.scene.triangle_count() < most_triangles;
    if (const auto hit = names ? pick_triangle(chapter.scene, ray) : std::nullopt) {
        const DrawItem& item = chapter.scene.items[hit->item];
        words_.push_back(name_of(chapter.scene.file.objects[item.object]));
        if (!item.material.name.empty()) words_.push_back(printable(item.material.name));
    }
    std::string all;
    for (const std::string& one : words_) all += " | " + one;
    log_event("pixel" + all);
}

}  // namespace lightwalk
