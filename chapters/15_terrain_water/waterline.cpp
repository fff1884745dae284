#include <algorithm>
#include <cmath>

#include "15_terrain_water/ocean.h"
#include "15_terrain_water/water.h"

namespace lightwalk {
namespace {

constexpr double tension = 7.4e-5;  // of water over its density, m³/s²

// Capillary waves and waves under gravity in one: omega^2 = g k + (sigma / rho) k^3 (H. Lamb, Hydrodynamics, 1932, art. 267).
double phase_at(double time_s, double length_m) {
    const double k = 2 * M_PI / length_m;
    return std::fmod(std::sqrt(gravity * k + tension * k * k * k) * time_s, 2 * M_PI);
}

}  // namespace

void Waterline::record(Frame& frame, const Scene& scene, float level_m, glm::vec2 from_wind) {
    exists_ = false;
    if (method.is("none")) return;
    Bounds around;
    const DrawList crossing = scene.all().where([&](const DrawItem& item) {
        const bool crosses = item.bounds.lower.y < level_m && item.bounds.upper.y > level_m;
        if (crosses) around.add(item.bounds);
        return crosses;
    });
    if (around.empty()) return;
    exists_ = true;
    const float margin_m = std::max(3.0f * reach_m, foam_m.value);
    const float side_m = std::max(around.extent().x, around.extent().z) + 2.0f * margin_m;
    map_.corner = glm::vec2(around.center().x, around.center().z) - 0.5f * side_m;
    map_.side_m = side_m;
    map_.length_m = length_m;
    map_.slope = slope;
    map_.reach_m = reach_m;
    map_.foam_m = foam_m;
    map_.most_texels = int(std::ceil(margin_m / side_m * float(texels)));
    map_.from_wind = from_wind;
    for (int i = 0; i < RING_WAVES; ++i)
        map_.phase[i] = float(phase_at(double(frame.time_s), double(length_m) * std::pow(double(RING_RATIO), i)));
    if (made_.is_current(scene.epoch, level_m, texels.value, margin_m)) return;
    draw(frame, crossing, level_m, around.upper.y);
    spread(frame);
}

// From above, and clipped at the water: only what is above it is counted.
void Waterline::draw(Frame& frame, const DrawList& crossing, float level_m, float top_m) {
    const auto fit = [&](Image& image, const char* name, VkFormat format) {
        image.ensure(frame.gpu.device,
                     {.name = path() + name, .format = format, .size = glm::uvec2(uint32_t(texels)), .kept = true});
    };
    fit(windings_, " windings", VK_FORMAT_R16_SFLOAT);
    fit(along_rows_, " along rows", VK_FORMAT_R32_SFLOAT);
    fit(distances_, " distances", VK_FORMAT_R32_SFLOAT);
    const float across = 2.0f / map_.side_m, up = 1.0f / (1.01f * (top_m - level_m) + 1e-3f);
    View above{.eye = {map_.corner.x, top_m, map_.corner.y}, .size = glm::uvec2(uint32_t(texels))};
    above.view_projection = glm::transpose(glm::mat4(across, 0, 0, -1 - across * map_.corner.x,  //
                                                     0, 0, across, -1 - across * map_.corner.y,  //
                                                     0, up, 0, -up * level_m,                    //
                                                     0, 0, 0, 1));
    const ViewScope scope(frame, above);
    frame.raster("waterline", {.color = {clear(windings_, glm::vec4(0.0f))}},
                 [&](Raster& pass) { pass.use(wind_).draw(crossing); });
}

// T. Saito and J.-I. Toriwaki, "New Algorithms for Euclidean Distance Transformation", Pattern Recognition 27(11), 1994:
// along rows, then along columns.
void Waterline::spread(Frame& frame) {
    const struct {
        int most;
        float texel_m;
    } line{map_.most_texels, map_.side_m / float(texels)};
    frame.compute("waterline distances", {.reads = {windings_, along_rows_}, .writes = {along_rows_, distances_}},
                  [&](Compute& pass) {
                      pass.use(rows_).set("from", windings_, nearest_clamp).set("result", along_rows_);
                      pass.set("line", line).dispatch_threads(distances_.desc.size).wait();
                      pass.use(columns_).set("from", along_rows_, nearest_clamp).set("result", distances_);
                      pass.set("line", line).dispatch_threads(distances_.desc.size);
                  });
}

void Waterline::bind(Pass& pass) const {
    if (!exists_) return;
    pass.set_if_present("waterline_map", map_);
    pass.set_if_present("waterline_distances", distances_, linear_clamp);
}

std::vector<Resource> Waterline::reads() const {
    return exists_ ? std::vector<Resource>{distances_} : std::vector<Resource>{};
}

}  // namespace lightwalk
