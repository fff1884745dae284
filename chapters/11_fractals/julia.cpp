#include "11_fractals/julia.h"

#include "common/scene/view.h"
#include "11_fractals/exercises.h"

namespace lightwalk {
namespace {

// In the order of Julia::constant, after custom. Dust falls apart: its c lies outside the Mandelbrot set.
constexpr glm::vec4 gallery[] = {{-0.445f, 0.339f, -0.0889f, -0.562f}, {-0.2f, 0.8f, 0.0f, 0.0f},
                                 {-0.291f, -0.399f, 0.339f, 0.437f},   {-0.125f, -0.256f, 0.847f, 0.0895f},
                                 {-0.213f, -0.041f, -0.563f, -0.56f},  {-1.0f, 0.2f, 0.0f, 0.0f},
                                 {0.285f, 0.01f, 0.0f, 0.0f}};
constexpr int morphed = 6;            // of them: not the dust
constexpr double seconds_each = 4.0;  // of the morph's way from one to the next

// Catmull and Rom's curve (1974) through p1 and p2.
glm::dvec4 along_curve(glm::dvec4 p0, glm::dvec4 p1, glm::dvec4 p2, glm::dvec4 p3, double t) {
    return p1 + 0.5 * t * (p2 - p0 + t * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3 + t * (3.0 * (p1 - p2) + p3 - p0)));
}

}  // namespace

float julia_bound(glm::vec4 constant) { return 0.5f + std::sqrt(0.25f + glm::length(constant)); }

glm::vec4 Julia::constant_at(double time_s) const {
    if (constant.is("custom")) return {c_xyz.value, c_k.value};
    if (!constant.is("morph")) return gallery[constant.index - 1];
    const double turn = time_s / seconds_each, whole = std::floor(turn);
    const auto at = [&](int i) {
        const auto index = static_cast<int>(std::fmod(whole, double(morphed))) + i + 2 * morphed;
        return glm::dvec4(gallery[index % morphed]);
    };
    return along_curve(at(-1), at(0), at(1), at(2), turn - whole);
}

// [record]
void Julia::record(Frame& frame, const Scene& scene, const Camera& camera, EnvironmentLight& environment) {
    const glm::vec4 c = constant_at(double(frame.time_s));
    now_ = {.rays = view_rays(camera, frame),
            .pixel_rad = 2.0f * std::tan(0.5f * camera.fov_y_rad) / static_cast<float>(frame.crop.whole.y),
            .constant = c,
            .bound = julia_bound(c),
            .tile = tile};
    for (const Light& light : scene.file.lights)
        if (light.kind == Light::Kind::directional) {
            now_.to_light = -glm::normalize(light.direction);
            now_.light = light.intensity * light.color;
            break;
        }

    // 1. Where the rays meet the set. For cones, first how far a whole tile of pixels may go.
    if (method.is("cone"))
        record_cones(frame, {cone_, march_, starts_, found, {*this}});
    else
        frame.compute("julia march", {.writes = {found}, .with = {*this}},
                      [&](Compute& pass) { pass.use(march_).set("found", found).dispatch_threads(frame.size); });

    // 2. What light they find there.
    frame.compute("julia shade", {.reads = {found}, .writes = {frame.hdr}, .with = {*this, environment}},
                  [&](Compute& pass) {
                      pass.use(shade_).set("found", found, nearest_clamp).set("result", frame.hdr);
                      pass.dispatch_threads(frame.size);
                  });
}
// [/record]

}  // namespace lightwalk
