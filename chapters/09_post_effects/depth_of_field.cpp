#include "09_post_effects/depth_of_field.h"

#include <cmath>

#include "01_obj/camera_view.h"
#include "08_bloom/exercises.h"
#include "08_bloom/step_parameters.h"
#include "common/app/show_image.h"

namespace lightwalk {
namespace {

constexpr VkFormat half4 = VK_FORMAT_R16G16B16A16_SFLOAT, half2 = VK_FORMAT_R16G16_SFLOAT;
constexpr float nearest_focus = 1.01f;  // in focal lengths

float radical_inverse(uint32_t bits) {
    float inverse = 0, digit = 0.5f;
    for (; bits; bits >>= 1, digit *= 0.5f) inverse += float(bits & 1u) * digit;
    return inverse;
}

}  // namespace

DepthOfField::DepthOfField(Module& owner, std::string name) : Module(owner, std::move(name), "dof") {}

float DepthOfField::focal_m(const Camera& camera) const {
    return 0.5f * 1e-3f * sensor_mm / std::tan(0.5f * camera.fov_y_rad);
}

// circle_of_confusion() narrows the view as it focuses nearer, as lenses do; the camera's view stays. So its lens is as
// much wider.
float DepthOfField::radius_m(const Camera& camera) const {
    const float focal = focal_m(camera), focus = std::max(focus_m.value, nearest_focus * focal);
    return 0.5f * focal / f_number * focus / (focus - focal);
}

namespace {

// Number i of `count` places that are evenly spread over a lens of that radius.
glm::vec2 lens_place(int i, int count, float radius_m) {
    const float r = radius_m * std::sqrt((float(i) + 0.5f) / float(count));
    const float angle = 6.28318531f * radical_inverse(static_cast<uint32_t>(i));
    return r * glm::vec2(std::cos(angle), std::sin(angle));
}

// View from a point of the lens: the camera moves there, and points at the distance f are shifted back from the slope
// (x - point) / f to x / f.
View from_place(const View& view, glm::vec2 place, float focus_m) {
    Camera moved = view.camera;
    const glm::vec3 forward = glm::normalize(moved.target - moved.position);
    const glm::vec3 right = glm::normalize(glm::cross(forward, moved.up)), up = glm::cross(right, forward);
    moved.position += place.x * right + place.y * up;
    moved.target += place.x * right + place.y * up;
    Crop crop = view.crop;
    crop.shift += glm::vec2(-place.x, place.y) / (focus_m * view.pixel_rad());
    View from = view_of(moved, view.size, crop);
    from.id = view.id;
    return from;
}

}  // namespace

void DepthOfField::sample_lens(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings) {
    Image& mean = image(frame, "mean", VK_FORMAT_R32G32B32A32_SFLOAT, view.size);
    const float focus = std::max(focus_m.value, nearest_focus * focal_m(view.camera)), radius = radius_m(view.camera);
    const ImageView color = canvas.color_overwritten();
    for (int i = 0; i < views; ++i) {
        Canvas one(color, canvas.depth_overwritten(), canvas.background());
        one.blended_by(canvas.transparency_method());
        draw(frame, from_place(view, lens_place(i, views, radius), focus), one, drawings);
        frame.compute("dof mean", {.reads = {color, mean}, .writes = {mean}}, [&](Compute& pass) {
            pass.use(add_).set("hdr", color, nearest_clamp).set("mean", mean);
            pass.set("weight", 1.0f / float(i + 1)).dispatch_threads(view.size);
        });
    }
    show_image(frame, mean, color, {.pass = "dof take"});
}

Image& DepthOfField::image(Frame& frame, const char* name, VkFormat format, glm::uvec2 size) {
    Image& found = images_[name];
    const Image::Desc desc{.name = path() + " " + name, .format = format, .size = size};
    found.ensure(frame.gpu.device, desc);
    return found;
}

void DepthOfField::set_up(const View& view) {
    const Camera& camera = view.camera;
    const float height_px = float(view.crop.whole.y);
    const float focal = focal_m(camera), sensor_m = 1e-3f * sensor_mm,
                focus = std::max(focus_m.value, nearest_focus * focal);
    const float wide_m = focal / f_number * focal / (focus - focal);
    const float most_px = most * height_px;
    now_ = {.inverse_near = 1.0f / camera.near_m,
            .inverse_far = std::isinf(camera.far_m) ? 0.0f : 1.0f / camera.far_m,
            .focal_m = focal,
            .sensor_m = sensor_m,
            .height_px = height_px,
            .most_px = most_px,
            .wide_px = std::min(wide_m / sensor_m * height_px, most_px),
            .reach = std::ceil(0.5f * most_px / 16.0f) + 1.0f};
}

void DepthOfField::record(Frame& frame, const View& view, Canvas& canvas, const Drawings& drawings) {
    if (method.is("lens")) return sample_lens(frame, view, canvas, drawings);
    draw(frame, view, canvas, drawings);
    if (method.is("off")) return;
    set_up(view);
    const ImageView hdr = canvas.color(frame), depth = canvas.depth(frame);
    const glm::uvec2 size = (view.size + 1u) / 2u;
    Image& small = image(frame, "half", half4, size);
    frame.compute("dof half", {.reads = {hdr, depth}, .writes = {small}, .with = {*this}}, [&](Compute& pass) {
        pass.use(half_).set("hdr", hdr, nearest_clamp).set("depth", depth, nearest_clamp);
        pass.set("result", small).set("dof_now", now_).dispatch_threads(size);
    });
    method.is("gather") ? gather(frame) : blur(frame);
    const Image& far_field = images_["far"];
    const bool gathers = method.is("gather");
    ComputeAccess access{.reads = {hdr, depth, far_field}, .writes = {hdr}, .with = {*this}};
    if (gathers) access.reads.push_back(images_["near"]);
    frame.compute("dof compose", access, [&](Compute& pass) {
        pass.use(compose_).set("hdr", hdr).set("depth", depth, nearest_clamp).set("dof_now", now_);
        pass.set("far_field", far_field, linear_clamp);
        if (gathers) pass.set("near_field", images_["near"], linear_clamp);
        pass.dispatch_threads(view.size);
    });
}

void DepthOfField::gather(Frame& frame) {
    const Image& small = images_["half"];
    const glm::uvec2 size = small.desc.size, tiles = (size + 7u) / 8u;
    Image &nearest = image(frame, "tiles", half2, tiles), &reached = image(frame, "reached", half2, tiles);
    Image &rough_far = image(frame, "rough far", half4, size), &rough_near = image(frame, "rough near", half4, size);
    Image &far_field = image(frame, "far", half4, size), &near_field = image(frame, "near", half4, size);

    frame.compute("dof tiles", {.reads = {small, nearest}, .writes = {nearest, reached}, .with = {*this}},
                  [&](Compute& pass) {
                      pass.use(tiles_).set("half_picture", small, nearest_clamp).set("tiles", nearest);
                      pass.dispatch(glm::uvec3(tiles, 1)).wait();
                      pass.use(spread_).set("tiles", nearest, nearest_clamp).set("reached", reached);
                      pass.set("dof_now", now_).dispatch_threads(tiles);
                  });
    frame.compute(
        "dof gather", {.reads = {small, reached}, .writes = {rough_far, rough_near}, .with = {*this}},
        [&](Compute& pass) {
            pass.use(gather_).set("half_picture", small, nearest_clamp).set("reached", reached, nearest_clamp);
            pass.set("far_field", rough_far).set("near_field", rough_near).dispatch_threads(size);
        });
    frame.compute(
        "dof fill",
        {.reads = {small, reached, rough_far, rough_near}, .writes = {far_field, near_field}, .with = {*this}},
        [&](Compute& pass) {
            pass.use(fill_).set("half_picture", small, nearest_clamp).set("reached", reached, nearest_clamp);
            pass.set("far_field", rough_far, linear_clamp).set("near_field", rough_near, linear_clamp);
            pass.set("far_result", far_field).set("near_result", near_field).dispatch_threads(size);
        });
}

// As it was first taught: one Gaussian for the whole picture, with chapter 08's lines. A disc of diameter d has the
// standard deviation d / 4.
void DepthOfField::blur(Frame& frame) {
    const Image& small = images_["half"];
    const glm::uvec2 size = small.desc.size;
    Image &along_x = image(frame, "line", half4, size), &far_field = image(frame, "far", half4, size);
    if (const float sigma_px = 0.5f * now_.wide_px / 4.0f; !taps_made_.is_current(sigma_px)) {
        std::vector<glm::vec2> weighed;
        for (const float weight : gaussian_weights(sigma_px, 3.0f)) weighed.emplace_back(float(weighed.size()), weight);
        taps_ = frame.gpu.upload("dof taps", weighed);
        tap_count_ = static_cast<uint32_t>(weighed.size());
    }
    frame.compute("dof blur", {.reads = {small, along_x, far_field, taps_}, .writes = {along_x, far_field}},
                  [&](Compute& pass) {
                      const auto line = [&](const Image& from, const Image& into, glm::ivec2 direction) {
                          pass.use(line_).set("taps", taps_).set("from", from, linear_clamp).set("into", into);
                          pass.set("step_now", StepParameters{.direction = direction,
                                                              .first_tap = 0,
                                                              .taps = static_cast<int>(tap_count_),
                                                              .spread = 0.0f,
                                                              .weight = 1.0f,
                                                              .keep = 0.0f});
                          pass.dispatch_threads(size);
                      };
                      line(small, along_x, {1, 0});
                      pass.wait();
                      line(along_x, far_field, {0, 1});
                  });
}

}  // namespace lightwalk
