#include "04_surface_maps/surface_scene.h"

namespace lightwalk {

SurfacePipelines see_through(const char* fragment, Macros macros) {
    macros.set("TRANSPARENT", "1");
    return SurfacePipelines(
        {.fragment = fragment, .depth_write = false, .blend = Blend::filtered, .macros = std::move(macros)});
}

SurfaceScene::SurfaceScene(Module& owner, std::string name, const char* fragment)
    : Drawing(owner, std::move(name)),
      maps(owner, "maps"),
      lights(owner, "lights"),
      shade_({.fragment = fragment}),
      see_through_(see_through(fragment)),
      see_through_tiles_(see_through(fragment, {{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}})) {
    lights.method.change_default("every_light");
}

void SurfaceScene::update(Frame& frame) {
    if (all_lights)
        lights.update(frame, *scene_, all_lights(frame));
    else
        lights.update(frame, *scene_, scene_->lights());
}

std::vector<With> SurfaceScene::given() const {
    std::vector<With> with{maps, lights};
    with.insert(with.end(), shading.with.begin(), shading.with.end());
    if (shadows) with.emplace_back(*shadows);
    return with;
}

std::vector<const Module*> SurfaceScene::dependencies() const {
    std::vector<const Module*> all{this};
    for (const PassInputs& given : given())
        if (const auto* module = dynamic_cast<const Module*>(&given)) all.push_back(module);
    return all;
}

std::vector<Batch> SurfaceScene::opaque_batches() const { return drawn ? drawn() : scene_->opaque().batches(); }

std::function<void(Raster&)> SurfaceScene::by(const SurfacePipelines& both, std::vector<Batch> batches) const {
    return [this, &both, batches = std::move(batches)](Raster& pass) {
        maps.draw(pass, *scene_, batches, both.loaded, both.displaced);
    };
}

void SurfaceScene::draw_lit(Frame& frame, Canvas& canvas, const std::function<void()>& sort) {
    // 1. Light lists, if the method has cells; tiles need depth.
    if (lights.needs_depth())
        frame.raster("depth", {.depth = canvas.single_depth_target(), .reads = shading.reads, .with = {maps}},
                     by(depth_pipelines()));
    sort();

    // 2. Shading of opaque surfaces.
    frame.raster(
        "shade",
        {.color = {canvas.color_target()}, .depth = canvas.depth_target(), .reads = shading.reads, .with = given()},
        by(opaque_pipelines()));
}

std::vector<TransparentSource::Transparent> SurfaceScene::transparent(const View& view) const {
    std::vector<Transparent> all;
    const DrawList list = scene_->transparent();
    for (const uint32_t i : list.items()) {
        const glm::vec3 middle = scene_->items[i].bounds.center();
        all.push_back({glm::length(middle - view.eye), i, middle});
    }
    return all;
}

const SurfacePipelines& SurfaceScene::transparent_pipelines() const {
    return shading.transparent ? *shading.transparent : lights.method.is("tiled") ? see_through_tiles_ : see_through_;
}

void SurfaceScene::draw_transparent(Raster& pass, std::span<const Transparent> items) const {
    std::vector<Batch> one_by_one;
    for (const Transparent& item : items) one_by_one.emplace_back(*scene_, item.item, 1u);
    const SurfacePipelines& both = transparent_pipelines();
    maps.draw(pass, *scene_, one_by_one, both.loaded, both.displaced);
}

std::vector<TransparentSource::TransparentTriangle> SurfaceScene::transparent_triangles(const View& view) const {
    std::vector<TransparentTriangle> all;
    const DrawList list = scene_->transparent();
    for (const uint32_t i : list.items()) {
        const DrawItem& item = scene_->items[i];
        const Mesh& mesh = item.model->model.meshes[item.mesh];
        const Part& part = mesh.parts[item.part];
        const std::vector<Vertex>& vertices = vertices_of(*item.model, item.mesh);
        for (uint32_t at = part.first_index; at + 2 < part.first_index + part.index_count; at += 3) {
            const glm::uvec3 corners(mesh.indices[at], mesh.indices[at + 1], mesh.indices[at + 2]);
            const glm::vec3 sum =
                vertices[corners.x].position + vertices[corners.y].position + vertices[corners.z].position;
            const glm::vec3 middle(item.transform * glm::vec4(sum / 3.0f, 1.0f));
            all.push_back({glm::length(middle - view.eye), i, corners});
        }
    }
    return all;
}

void SurfaceScene::draw_transparent_triangles(Raster& pass, uint32_t item, const Buffer& indices, uint32_t first,
                                              uint32_t count) const {
    const Batch batch(*scene_, item, 1);
    pass.use(transparent_pipelines().loaded, maps.variant(batch.item()));
    pass.set_if_present("ambient", scene_->ambient());
    batch.bind(pass);
    pass.draw_indexed(indices, first, count, 1, item);
}

}  // namespace lightwalk
