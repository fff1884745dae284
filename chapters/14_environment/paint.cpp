#include "14_environment/paint.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

#include "14_environment/paint_data.h"
#include "14_environment/substance_data.h"
#include "common/base/error.h"
#include "common/base/exercise.h"

namespace lightwalk {

CarPaint::CarPaint(Module& owner, std::string name) : Module(owner, std::move(name), "paint") {}

void CarPaint::prepare(Gpu&, Scene& scene) {
    made_.forget();
    brdf_.reset();
    measured_ = {};
    name_unused_placement(scene.file, is_measured_file, "a measured BRDF");
    const SceneObject* const shown = first_shown(scene.file, is_measured_file);
    given_ = shown != nullptr;
    if (!shown) return;
    if (scene.file.bare && shown == &scene.file.objects.front())
        throw InputError("{}: a BRDF has no shape; name the file in a scene, as assets/scenes/measured_paint.json does",
                         shown->model.string());
    brdf_ = read_measured(find_asset(shown->model));
}

// Cells without data, below the surface or unseen by the instrument, repeat the last one with data along θd: filtering
// reads beyond the horizon.
void CarPaint::load(Frame& frame) {
    if (!brdf_) brdf_ = read_measured(find_asset("tables/flakes.binary"));
    fit_ = fit_paint(*brdf_);
    const glm::ivec3 cells = brdf_->cells;
    std::vector<uint64_t> texels(brdf_->values.size());
    MeasuredBrdf filled = *brdf_;
    size_t texel = 0;
    each_cell(cells, [&](glm::ivec3 cell) {
        glm::dvec3& value = filled.at(cell);
        if (std::min({value.r, value.g, value.b}) < 0)
            value = cell.y > 0 ? filled.at(cell - glm::ivec3(0, 1, 0)) : glm::dvec3(0);
        texels[texel++] = glm::packHalf4x16(glm::vec4(glm::min(value, 65504.0), 1.0));
    });
    measured_ = Image(frame.gpu.device, {.name = path() + " measured",
                                         .size = {uint32_t(cells.z), uint32_t(cells.y)},
                                         .depth = uint32_t(cells.x),
                                         .kept = true});
    frame.upload("measured paint", measured_, std::as_bytes(std::span(texels)));
}

void CarPaint::record(Frame& frame) {
    if (made_.is_current(epoch())) return;
    if (!method.is("layers") && !measured_) load(frame);
    frame.compute("paint table", {.writes = {table}, .with = {*this}},
                  [&](Compute& pass) { pass.use(fill_).set("table", table).dispatch_threads(table.desc.size); });
}

std::vector<Resource> CarPaint::reads() const {
    return measured_ ? std::vector<Resource>{table, measured_} : std::vector<Resource>{table};
}

void CarPaint::bind(Pass& pass) const {
    pass.set_if_present("paint_table", table, linear_clamp);
    pass.set_if_present("paint_fit", fit_);
    if (measured_) pass.set_if_present("paint_measured", measured_, linear_clamp);
}

size_t CarPaint::bytes() const {
    if (method.is("fit")) return sizeof(PaintFit);
    return method.is("measured") ? byte_count(measured_) : 8 * size_t(PAINT_TEXELS * PAINT_TEXELS);
}

namespace {

/// Materials without texture coordinates that are not smooth, by their name in the model's file.
struct Bumps {
    const char* material;
    float per_m, depth;
};
constexpr Bumps all_bumps[] = {
    {"tyre", 120.0f, 0.45f}, {"rubber", 400.0f, 0.3f}, {"interior", 500.0f, 0.35f}, {"plastic", 900.0f, 0.2f}};

// Of MTL's illumination models those with "transparency: glass on" or "refraction on"; loaders give 4 to other glass.
bool is_glass(int illumination) {
    return illumination == 4 || illumination == 6 || illumination == 7 || illumination == 9;
}

}  // namespace

void Substances::prepare(Gpu& gpu, Scene& scene) {
    std::vector<SubstanceData> substances;
    for (const DrawItem& item : scene.items) {
        const bool in_scene = item.roughness >= 0 || item.metalness >= 0 || item.maps[MapSlot::orm];
        const float rough = item.material.roughness;
        // A material that says nothing has the default; then its exponent says how rough it is.
        const bool in_model = !in_scene && rough != Material{}.roughness;
        SubstanceData& own = substances.emplace_back();
        own.alpha = in_model ? std::max(rough * rough, 1e-3f) : -1.0f;
        own.metalness = in_scene ? 0.0f : item.material.metalness;
        own.glass = is_glass(item.material.illumination) ? 1u : 0u;
        own.paint = item.material.name == "paint" && !in_scene ? 1u : 0u;
        for (const Bumps& bumps : all_bumps)
            if (item.material.name == bumps.material) {
                own.bumps_per_m = bumps.per_m;
                own.bump_depth = bumps.depth;
            }
    }
    if (substances.empty()) substances.emplace_back();
    substances_ = gpu.upload("substances", substances);
}

}  // namespace lightwalk
