#include <glm/gtc/matrix_transform.hpp>

#include "13_mlaa/mlaa.h"

namespace lightwalk {
namespace {

// As 13_mlaa/taa.comp has it.
struct TaaPush {
    glm::mat4 to_before;  ///< clip space now to clip space of the frame before
    glm::vec2 shift;      ///< of this frame, pixels
    float inverse_near, inverse_far;
    float at_rest, in_motion, gamma;
    uint32_t valid, rests;
};

// J. H. Halton's sequence (1960) in one base, less 1/2.
float halton(int index, int base) {
    float value = 0.0f, digit = 1.0f;
    for (; index > 0; index /= base) {
        digit /= static_cast<float>(base);
        value += digit * static_cast<float>(index % base);
    }
    return value - 0.5f;
}

glm::vec2 shift_of_frame(int frame) { return {halton(frame % 4096 + 1, 2), halton(frame % 4096 + 1, 3)}; }

// In double precision: a float inverse cannot separate two pixels far from the origin.
glm::dmat4 to_before(const View& now, const View& before) {
    const glm::dvec3 moved = now.exact_eye && before.exact_eye ? *now.exact_eye - *before.exact_eye : glm::dvec3(0.0);
    return glm::dmat4(without_shift(before)) * glm::translate(glm::dmat4(1.0), moved) *
           glm::inverse(glm::dmat4(without_shift(now)));
}

}  // namespace

Accumulation Taa::accumulation() const { return {warm_up, shift_of_frame}; }

// Returns whether there is a history to mix with.
bool Taa::set_up(Frame& frame, glm::uvec2 size, const Seen& seen) {
    Device& device = frame.gpu.device;
    std::swap(light_[0], light_[1]);
    std::swap(behind_[0], behind_[1]);
    bool is_new = false;
    for (Image& image : light_)
        is_new |= image.ensure(device, {.name = path() + " history", .size = size, .kept = true});
    for (Image& image : behind_)
        is_new |= image.ensure(
            device, {.name = path() + " behind", .format = VK_FORMAT_R32_SFLOAT, .size = size, .kept = true});
    const std::filesystem::path file = seen.scene ? seen.scene->file.file : std::filesystem::path();
    const bool same = before_ && before_->size == seen.view.size && scene_ == seen.scene && scene_file_ == file;
    scene_ = seen.scene;
    scene_file_ = file;
    remembered_.written = true;
    return remembered_.valid && same && !is_new;
}

// Whether camera, scene, lights and drawings are as in the frame before: then each frame is one more sample of the same
// picture.
bool Taa::is_unchanged(const Frame& frame, const Seen& seen) {
    const View& now = seen.view;
    const LightList lights = seen.scene ? seen.scene->lights() : nullptr;
    const bool same_lights = std::exchange(lights_, lights) == lights;
    Hash drawn;
    bool moved = false, animated = false;
    for (const Drawing& drawing : seen.drawings) {
        const auto* surface = dynamic_cast<const MovingSurface*>(&drawing);
        moved |= surface && surface->has_moved();
        for (const Module* module : drawing.dependencies()) {
            drawn.add(module->epoch());
            animated |= module->any_animated();
        }
    }
    const bool same =
        unchanged_.is_current(now.camera, now.exact_eye.value_or(glm::dvec3(0.0)), now.crop.origin, now.crop.whole,
                              seen.scene ? seen.scene->epoch : 0, drawn.value, animated ? frame.time_s : 0.0f);
    return same && same_lights && !moved && !seen.drawings.empty();
}

void Taa::record(Frame& frame, const Image& picture, const Seen& seen) {
    const bool valid = set_up(frame, picture.desc.size, seen);
    const View& now = seen.view;
    const Image &light = light_[0], &light_before = light_[1], &behind = behind_[0], &behind_before = behind_[1];

    // 1. Motion of what moves by itself. Depth suffices for all else, which moves with the camera alone.
    const bool moves =
        valid && motion && seen.scene && moving_.record(frame, *seen.scene, now, *before_, seen.depth, seen.drawings);

    // 2. History at each pixel's former position, clipped to the pixel's new neighbourhood, mixed with the new light.
    TaaPush step{.to_before = valid ? glm::mat4(to_before(now, *before_)) : glm::mat4(1.0f),
                 .shift = now.crop.shift,
                 .inverse_near = 1.0f / now.camera.near_m,
                 .inverse_far = 1.0f / now.camera.far_m,
                 .at_rest = at_rest,
                 .in_motion = in_motion,
                 .gamma = gamma,
                 .valid = valid,
                 .rests = is_unchanged(frame, seen) && valid};
    ComputeAccess access{.reads = {picture, seen.depth}, .writes = {light, behind}, .with = {*this}};
    for (const Image* image : {&light_before, &behind_before})
        if (valid) access.reads.emplace_back(*image);
    if (moves) access.reads.emplace_back(moving_.image());
    frame.compute("taa", access, [&](Compute& pass) {
        pass.use(moves ? follow_ : still_).set("picture", picture, nearest_clamp);
        pass.set("depth", seen.depth, nearest_clamp).set("taa_step", step);
        pass.set("history", valid ? light_before : picture, linear_clamp);
        pass.set("behind_before", valid ? behind_before : picture, nearest_clamp);
        if (moves) pass.set("moving", moving_.image(), nearest_clamp);
        pass.set("light", light).set("behind", behind).dispatch_threads(picture.desc.size);
    });

    // 3. The mixture is the picture.
    frame.compute("taa show", {.reads = {light, picture}, .writes = {picture}}, [&](Compute& pass) {
        pass.use(show_).set("light", light, nearest_clamp).set("picture", picture);
        pass.dispatch_threads(picture.desc.size);
    });
    if (seen.scene) moving_.keep(frame, *seen.scene);
    before_ = now;
}

}  // namespace lightwalk
