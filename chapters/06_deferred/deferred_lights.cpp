#include "06_deferred/deferred_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lightwalk {

void DeferredLights::update(Frame& frame, const Scene& scene, const View& view, const GBuffer& gbuffer,
                            const Lights& lights) {
    is_tiled_ = gbuffer.method.is("tiled");
    has_volumes_ = gbuffer.volumes && !is_tiled_;
    if (has_volumes_) volumes_.update(frame, lights);
    if (is_tiled_)
        tiles_.set_view(view, scene.bounds, LightGrid::Cells::tiles, 1, 0,
                        lights.falloff.is("inverse_square") ? lights.threshold : 0.0f);
}

void DeferredLights::light_pixels(Compute& pass, const ImageView& color, glm::vec3 ambient, glm::vec3 background,
                                  bool ggx, bool emits) const {
    const Macros variant{{"SURFACE_GGX", ggx ? "1" : "0"}, {"EMITS", emits ? "1" : "0"}};
    pass.use(is_tiled_ ? tiled_ : full_screen_, variant).set("hdr", color);
    pass.set("ambient", ambient).set("background", background);
    if (is_tiled_) pass.set("lights_grid", tiles_.view);
    if (has_volumes_) pass.set("without_volume", volumes_.without);
    pass.dispatch_threads(color.size());
}

void DeferredLights::light_volumes(Raster& pass, bool ggx) const {
    volumes_.draw(pass.use(volume_, {{"SURFACE_GGX", ggx ? "1" : "0"}}));
}

void DeferredLights::record(Frame& frame, const Scene& scene, glm::vec3 ambient, const View& view, Canvas& canvas,
                            const GBuffer& gbuffer, const Lights& lights, const std::vector<With>& with, bool ggx,
                            bool emits) {
    update(frame, scene, view, gbuffer, lights);
    const ImageView color = canvas.color_overwritten();
    std::vector<Resource> reads{canvas.depth(frame)};
    if (emits) reads.emplace_back(color);
    frame.compute(
        is_tiled_ ? "tiles" : "full_screen", {.reads = reads, .writes = {color}, .with = with},
        [&](Compute& pass) { light_pixels(pass, color, ambient, glm::vec3(canvas.background()), ggx, emits); });
    if (has_volumes_)
        frame.raster("volumes", {.color = {canvas.color_target()}, .depth = canvas.depth_read_only(), .with = with},
                     [&](Raster& pass) { light_volumes(pass, ggx); });
}

void DeferredLights::show(Frame& frame, Canvas& canvas, const GBuffer& gbuffer) {
    const ImageView color = canvas.color(frame);
    frame.compute("show", {.reads = {canvas.depth(frame), color}, .writes = {color}, .with = {gbuffer}},
                  [&](Compute& pass) { pass.use(show_).set("hdr", color).dispatch_threads(canvas.size()); });
}

namespace {

constexpr uint32_t sides = 16;
constexpr float slack = 1.005f;  // margin against rounding into the lit region

glm::vec2 on_circle(uint32_t i, uint32_t count) {
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(count);
    return {std::cos(angle), std::sin(angle)};
}

std::vector<glm::vec3> sphere_mesh() {
    constexpr uint32_t rows = sides / 2;
    const auto at = [&](uint32_t row, uint32_t column) {
        const glm::vec2 polar = on_circle(row, 2 * rows), around = on_circle(column % sides, sides);
        return glm::vec3(polar.y * around, polar.x);
    };
    std::vector<glm::vec3> corners;
    for (uint32_t row = 0; row < rows; ++row)
        for (uint32_t column = 0; column < sides; ++column) {
            const glm::vec3 a = at(row, column), b = at(row + 1, column), c = at(row + 1, column + 1),
                            d = at(row, column + 1);
            if (row + 1 < rows) corners.insert(corners.end(), {a, b, c});
            if (row > 0) corners.insert(corners.end(), {a, c, d});
        }
    // Enlarged until the nearest face touches the sphere, since a mesh with corners on the sphere lies inside it.
    float nearest = 1.0f;
    for (size_t i = 0; i < corners.size(); i += 3)
        nearest = std::min(
            nearest,
            glm::dot(corners[i], glm::normalize(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]))));
    for (glm::vec3& corner : corners) corner *= slack / nearest;
    return corners;
}

std::vector<glm::vec3> cone_mesh() {
    const float wide = slack / std::cos(std::numbers::pi_v<float> / sides);
    const glm::vec3 apex(0.0f, 0.0f, 1.0f - slack), base(0.0f, 0.0f, slack);
    std::vector<glm::vec3> corners;
    for (uint32_t i = 0; i < sides; ++i) {
        const glm::vec3 a(wide * on_circle(i, sides), slack), b(wide * on_circle((i + 1) % sides, sides), slack);
        corners.insert(corners.end(), {apex, b, a, base, a, b});
    }
    return corners;
}

}  // namespace

std::vector<glm::vec3> volume_mesh(LightVolume::Shape shape) {
    return shape == LightVolume::Shape::sphere ? sphere_mesh() : cone_mesh();
}

void LightVolumes::update(Frame& frame, const Lights& lights) {
    if (made_.is_current(lights.buffer().rebuilds, lights.epoch())) return;
    std::vector<LightVolumeData> spheres, cones;
    std::vector<uint32_t> everywhere{0};
    const auto bounds = light_volume_bounds.function();
    for (uint32_t i = 0; i < lights.buffer().lights().size(); ++i) {
        const Light& light = lights.buffer().lights()[i];
        if (light.kind == Light::Kind::directional) {
            everywhere.push_back(i);
            continue;
        }
        const LightVolume volume = bounds(light, lights.reach_m(light));
        (volume.shape == LightVolume::Shape::sphere ? spheres : cones).push_back({volume.to_world, i});
    }
    spheres_ = static_cast<uint32_t>(spheres.size());
    cones_ = static_cast<uint32_t>(cones.size());
    spheres.insert(spheres.end(), cones.begin(), cones.end());
    frame.upload("light volumes", volumes_, spheres);
    everywhere[0] = static_cast<uint32_t>(everywhere.size() - 1);
    frame.upload("lights without volume", without, everywhere);
    if (sphere_) return;
    const auto sphere = volume_mesh(LightVolume::Shape::sphere), cone = volume_mesh(LightVolume::Shape::cone);
    sphere_corners_ = static_cast<uint32_t>(sphere.size());
    cone_corners_ = static_cast<uint32_t>(cone.size());
    frame.upload("sphere", sphere_, sphere);
    frame.upload("cone", cone_, cone);
}

void LightVolumes::draw(Raster& pass) const {
    pass.set("volumes", volumes_);
    if (spheres_) pass.set("corners", sphere_).draw(sphere_corners_, spheres_);
    if (cones_) pass.set("corners", cone_).draw(cone_corners_, cones_, spheres_);
}

}  // namespace lightwalk
