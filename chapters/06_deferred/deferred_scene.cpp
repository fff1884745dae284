#include "06_deferred/deferred_scene.h"

#include <utility>

namespace lightwalk {

DeferredScene::DeferredScene(Module& owner, std::string name, std::optional<Shading> fixed)
    : Drawing(owner, name), lit(owner, name, std::move(fixed)), gbuffer(owner, "gbuffer"), culling(owner, "culling") {
    lights.method.change_default("clustered");
}

std::vector<const Module*> DeferredScene::dependencies() const {
    std::vector<const Module*> all = lit.dependencies();
    all.push_back(&gbuffer);
    all.push_back(&culling);
    return all;
}

std::vector<With> DeferredScene::with(std::vector<With> modules) const {
    modules.insert(modules.end(), shading.with.begin(), shading.with.end());
    modules.emplace_back(culling);
    return modules;
}

// Displaced meshes are not culled.
std::function<void(Raster&)> DeferredScene::by(const SurfacePipelines& both, std::vector<Batch> batches) const {
    return [this, &both, batches = std::move(batches)](Raster& pass) {
        if (!culling.culls()) return maps.draw(pass, scene(), batches, both.loaded, both.displaced);
        const glm::vec3 ambient = scene().ambient();
        for (const Batch& batch : batches) {
            pass.use(both.loaded, maps.variant(batch.item()));
            pass.set_if_present("ambient", ambient);
            culling.draw(pass, batch);
        }
    };
}

std::vector<Batch> DeferredScene::batches_by_stored(bool stored) const {
    std::vector<Batch> kept;
    for (const Batch& batch : surfaces.opaque_batches()) {
        const DrawItem& item = batch.item();
        const bool other =
            maps.has_microfacets(item) != maps.surface.model.is("ggx");  // reflection model differs from the G-buffer's
        if (stored != (other || item.material.unlit)) kept.push_back(batch);
    }
    return kept;
}

void DeferredScene::draw(Frame& frame, const View& view, Canvas& canvas) {
    const bool overwrites = !gbuffer.is_forward() && canvas.has_color();
    if (!canvas.has_depth() && !overwrites) return draw_alone(frame, view, canvas);
    // Earlier drawings have filled depth or colour but no G-buffer, so this scene is drawn apart and merged by depth.
    const auto fit = [&](Image& image, const char* name, VkFormat format) {
        image.ensure(frame.gpu.device, {.name = path() + name, .format = format, .size = view.size});
    };
    fit(own_color_, " color", VK_FORMAT_R16G16B16A16_SFLOAT);
    fit(own_depth_, " depth", VK_FORMAT_D32_SFLOAT);
    Canvas own(own_color_, own_depth_, glm::vec4(0.0f));
    draw_alone(frame, view, own);
    frame.raster(
        "merge", {.color = {canvas.color_target()}, .depth = canvas.depth_target(), .reads = {own_color_, own_depth_}},
        [&](Raster& pass) {
            pass.use(merge_).set("color_map", own_color_, nearest_clamp).set("depth_map", own_depth_, nearest_clamp);
            pass.draw(3);
        });
}

void DeferredScene::draw_alone(Frame& frame, const View& view, Canvas& canvas) {
    // 1. Shadow maps; culling by bounds, which are valid for meshes as loaded.
    lit.record_shadows(frame, view);
    culling.begin(frame, scene(), view, maps.mesh.is("loaded") ? surfaces.opaque_batches() : std::vector<Batch>());

    // 2. Forward shading, or the G-buffer, its lighting, and what it cannot hold.
    gbuffer.begin(frame, view, canvas.single_depth());
    if (gbuffer.is_forward() || gbuffer.shows_loss())
        return draw_forward(frame, view, canvas, surfaces.opaque_batches());
    culling.passes(frame, canvas.depth_read_only().view, [&] {
        frame.raster("gbuffer",
                     {.color = gbuffer.targets(culling.completes()),
                      .depth = canvas.depth_target(),
                      .with = with({maps, gbuffer})},
                     by(written(), batches_by_stored(true)));
    });
    gbuffer.written();
    const glm::vec3 ambient = shading.rest ? glm::vec3(0.0f) : scene().ambient();
    const bool emits = write_emission(frame, canvas, emission_);
    deferred.record(frame, scene(), ambient, view, canvas, gbuffer, lights,
                    {lights, shadow, gbuffer, maps.surface, maps.lamps}, maps.surface.model.is("ggx"), emits);
    if (!gbuffer.show.is("picture")) return deferred.show(frame, canvas, gbuffer);
    draw_lit(frame, view, canvas, "unstored", batches_by_stored(false));
    // Light lists for transparent surfaces, shaded forward.
    if (scene().transparent().size() > 0) lights.record(frame, scene(), view, canvas.depth(frame));
}

void DeferredScene::draw_forward(Frame& frame, const View& view, Canvas& canvas, const std::vector<Batch>& batches) {
    const auto sort_lights = [&] { lights.record(frame, scene(), view, canvas.single_depth()); };
    const bool loss = gbuffer.shows_loss();
    if (!loss && lit.shades_in_compute(canvas)) return lit.draw_visible(frame, canvas, sort_lights, batches);
    if (lights.needs_depth() && !canvas.has_depth())
        culling.passes(frame, canvas.depth_read_only().view, [&] {
            frame.raster("depth", {.depth = canvas.depth_target(), .with = with({maps})},
                         by(surfaces.depth_pipelines(), batches));
        });
    sort_lights();
    culling.passes(frame, canvas.depth_read_only().view, [&] {
        const bool clears = loss && !culling.completes();
        const Attachment target = clears ? clear(canvas.color_overwritten(), glm::vec4(-1.0f)) : canvas.color_target();
        frame.raster("forward",
                     {.color = {target}, .depth = canvas.depth_target(), .with = with({maps, lights, shadow, gbuffer})},
                     by(loss ? lost_ : surfaces.opaque_pipelines(), batches));
    });
}

// Before the lights, which are added: two surfaces at one depth must not add their emission twice.
bool DeferredScene::write_emission(Frame& frame, Canvas& canvas, const SurfacePipelines& emission) {
    if (!shading.rest && !emits()) return false;
    const std::vector<Batch> stored = batches_by_stored(true);
    const std::vector<Batch> batches = shading.rest ? stored : emitting(scene(), stored);
    if (batches.empty()) return false;
    frame.raster(shading.rest ? "ambient and emission" : "emission",
                 {.color = {clear(canvas.color_overwritten(), glm::vec4(0.0f))},
                  .depth = canvas.depth_read_only(),
                  .with = with({maps, lights, shadow})},
                 by(shading.rest ? *shading.rest : emission, batches));
    return true;
}

bool DeferredScene::emits() {
    if (!emission_sought_.is_current(scene().epoch)) emits_ = !emitting(scene(), scene().opaque().batches()).empty();
    return emits_;
}

void DeferredScene::draw_lit(Frame& frame, const View& view, Canvas& canvas, const std::string& name,
                             const std::vector<Batch>& batches) {
    if (batches.empty()) return;
    if (lights.needs_depth())
        frame.raster("depth of " + name, {.depth = canvas.depth_target(), .with = with({maps})},
                     by(surfaces.depth_pipelines(), batches));
    lights.record(frame, scene(), view, canvas.depth(frame));
    frame.raster(
        name, {.color = {canvas.color_target()}, .depth = canvas.depth_target(), .with = with({maps, lights, shadow})},
        by(surfaces.opaque_pipelines(), batches));
}

void DeferredScene::draw_kept(Frame& frame, const View& view, Canvas& canvas) {
    const ViewScope from(frame, view);
    draw_lit(frame, view, canvas, "objects kept", surfaces.opaque_batches());
}

std::vector<Batch> emitting(const Scene& scene, const std::vector<Batch>& batches) {
    std::vector<Batch> kept;
    for (const Batch& batch : batches) {
        bool any = false;
        for (uint32_t i = 0; i < batch.count; ++i)
            any |= scene.items[batch.first + i].material.emissive != glm::vec3(0.0f);
        if (any) kept.push_back(batch);
    }
    return kept;
}

glm::vec2 mean_loss(const ImageRgb& picture) {
    glm::dvec2 sum(0.0);
    double count = 0;
    for (const glm::vec3& pixel : picture.pixels)
        if (pixel.r >= 0.0f) {
            sum += glm::dvec2(pixel);
            ++count;
        }
    return count > 0 ? sum / count : sum;
}

}  // namespace lightwalk
