#include "14_environment/screen_occlusion.h"

namespace lightwalk {
namespace {

// As 14_environment/occlusion_step.glsl has it.
struct Step {
    ViewRays rays;
    glm::vec2 shrink;      ///< pixels of the depth for one in which horizons are sought
    float pixels_per_rad;  ///< in the middle of the picture
    float radius_m, thickness;
    int32_t slices, steps;
};

}  // namespace

// [record]
void ScreenOcclusion::record(Frame& frame, const View& view, const ImageView& depth) {
    const glm::uvec2 size(depth.size()), small = resolution.is("half") ? (size + 1u) / 2u : size;
    const auto fit = [&](Image& image, const char* name, glm::uvec2 side) {
        image.ensure(frame.gpu.device, {.name = path() + name, .size = side});
    };
    fit(found_, " found", small);
    fit(wide_, " image", size);
    const Step step{.rays = view_rays(view),
                    .shrink = glm::vec2(resolution.is("half") ? 2.0f : 1.0f),
                    .pixels_per_rad = 1.0f / view.pixel_rad(),
                    .radius_m = radius_m,
                    .thickness = thickness,
                    .slices = slices,
                    .steps = steps};
    frame.compute("horizons", {.reads = {depth}, .writes = {found_}}, [&](Compute& pass) {
        pass.use(seek_).set("depth", depth, nearest_clamp).set("occlusion_step", step);
        pass.set("found", found_).dispatch_threads(small);
    });
    frame.compute("widen occlusion", {.reads = {depth, found_}, .writes = {wide_}}, [&](Compute& pass) {
        pass.use(widen_).set("depth", depth, nearest_clamp).set("occlusion_step", step);
        pass.set("found", found_, nearest_clamp).set("wide", wide_).dispatch_threads(size);
    });
}
// [/record]

std::vector<Resource> ScreenOcclusion::reads() const {
    return wide_ ? std::vector<Resource>{wide_} : std::vector<Resource>{};
}

void ScreenOcclusion::bind(Pass& pass) const {
    if (wide_) pass.set_if_present("screen_occlusion_image", wide_, nearest_clamp);
}

}  // namespace lightwalk
