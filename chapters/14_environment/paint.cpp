#include "14_environment/paint.h"

#include <algorithm>

#include "14_environment/substance_data.h"
#include "common/base/exercise.h"

namespace lightwalk {

CarPaint::CarPaint(Module& owner, std::string name) : Module(owner, std::move(name), "paint") {}

void CarPaint::record(Frame& frame) {
    if (made_.is_current(epoch())) return;
    frame.compute("paint table", {.writes = {table}, .with = {*this}},
                  [&](Compute& pass) { pass.use(fill_).set("table", table).dispatch_threads(table.desc.size); });
}

void CarPaint::bind(Pass& pass) const { pass.set_if_present("paint_table", table, linear_clamp); }

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
