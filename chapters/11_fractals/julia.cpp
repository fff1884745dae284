#include "11_fractals/julia.h"

#include "11_fractals/exercises.h"

namespace lightwalk {
namespace {

// In the order of Julia::constant, after custom. Dust falls apart: its c lies outside the Mandelbrot set.
constexpr glm::vec4 gallery[] = {{-0.445f, 0.339f, -0.0889f, -0.562f}, {-0.2f, 0.8f, 0.0f, 0.0f},
                                 {-0.291f, -0.399f, 0.339f, 0.437f},   {-0.125f, -0.256f, 0.847f, 0.0895f},
                                 {-0.213f, -0.041f, -0.563f, -0.56f},  {-1.0f, 0.2f, 0.0f, 0.0f},
                                 {0.285f, 0.01f, 0.0f, 0.0f}};
constexpr int on_curve = 6;           // of them: not the dust
constexpr double seconds_each = 4.0;  // of the morph's way from one to the next

// Catmull and Rom's curve (1974) through p1 and p2.
glm::dvec4 along_curve(glm::dvec4 p0, glm::dvec4 p1, glm::dvec4 p2, glm::dvec4 p3, double t) {
    return p1 + 0.5 * t * (p2 - p0 + t * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3 + t * (3.0 * (p1 - p2) + p3 - p0)));
}

}  // namespace

Julia::Julia(Module& owner, std::string name, EnvironmentLight& environment)
    : Drawing(owner, std::move(name), "julia"), environment_(environment) {}

float julia_bound(glm::vec4 constant) { return 0.5f + std::sqrt(0.25f + glm::length(constant)); }

glm::vec4 Julia::constant_at(double time_s) const {
    if (constant.is("custom")) return {c_xyz.value, c_k.value};
    if (!constant.is("morph")) return gallery[constant.index - 1];
    const double turn = time_s / seconds_each, whole = std::floor(turn);
    const auto at = [&](int i) {
        const auto index = static_cast<int>(std::fmod(whole, double(on_curve))) + i + 2 * on_curve;
        return glm::dvec4(gallery[index % on_curve]);
    };
    return along_curve(at(-1), at(0), at(1), at(2), turn - whole);
}

// Where the rays meet the set. For cones, first how far a whole tile of pixels may go.
void Julia::march(Frame& frame, const View& view) {
    constexpr VkFormat float4 = VK_FORMAT_R32G32B32A32_SFLOAT;
    Device& device = frame.gpu.device;
    found.ensure(device, {.name = path() + " found", .format = float4, .size = view.size});
    starts_.ensure(device, {.name = path() + " starts", .format = float4, .size = (view.size + tile - 1u) / tile});
    if (method.is("cone")) {
        // An answer may march no cones: its rays begin behind everything.
        if (!Exercises::uses_solution("11.record_cones")) frame.fill("julia no starts", starts_, glm::vec4(1e6f));
        record_cones(frame, {cone_, march_, starts_, found, {*this}});
    } else {
        frame.compute("julia march", {.writes = {found}, .with = {*this}},
                      [&](Compute& pass) { pass.use(march_).set("found", found).dispatch_threads(view.size); });
    }
}

void Julia::draw(Frame& frame, const View& view, Canvas& canvas) {
    const glm::vec4 c = constant_at(double(frame.time_s));
    const Sun sun = scene_->sun();
    now_ = {.rays = view_rays(view),
            .pixel_rad = view.pixel_rad(),
            .constant = c,
            .bound = julia_bound(c),
            .to_light = sun.to_sun,
            .light = sun.light,
            .tile = static_cast<int>(tile)};
    march(frame, view);

    // Shading of the hits; alone in the picture, with the environment behind the set.
    const bool alone = !canvas.has_color() && !canvas.has_depth();
    if (!alone) own_color_.ensure(frame.gpu.device, {.name = path() + " color", .size = view.size});
    const ImageView into = alone ? canvas.color_overwritten() : own_color_;
    frame.compute("julia shade", {.reads = {found}, .writes = {into}, .with = {*this, environment_}},
                  [&](Compute& pass) {
                      pass.use(shade_).set("found", found, nearest_clamp).set("result", into);
                      pass.dispatch_threads(view.size);
                  });

    // Depth for later drawings; nearer surfaces of earlier drawings stay.
    if (alone && !canvas.keeps_depth()) return;
    if (alone)
        frame.raster("julia depth", {.depth = canvas.depth_target(), .reads = {found}, .with = {*this}},
                     [&](Raster& pass) { pass.use(depth_).set("found", found, nearest_clamp).draw(3); });
    else
        frame.raster("julia merge",
                     {.color = {canvas.color_target()},
                      .depth = canvas.depth_target(),
                      .reads = {found, own_color_},
                      .with = {*this}},
                     [&](Raster& pass) {
                         pass.use(merge_).set("found", found, nearest_clamp);
                         pass.set("color_map", own_color_, nearest_clamp).draw(3);
                     });
}

}  // namespace lightwalk
