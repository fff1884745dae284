#include "05_shadow_maps/visibility_buffer.h"

namespace lightwalk {

ShadedChoice::ShadedChoice(Module& module)
    : Choice(module, "shaded", {"raster", "visibility"}, "raster",
             "Shading of opaque surfaces without a G-buffer: as they are drawn, by fragment shaders (raster), or in "
             "compute, once for each pixel of a visibility buffer; raster for displaced meshes and for several samples "
             "per pixel") {}

Attachment visibility_target(Frame& frame, Image& image, const Canvas& canvas) {
    image.ensure(frame.gpu.device, {.name = "visible", .format = VK_FORMAT_R32G32_UINT, .size = canvas.size()});
    return clear(image, glm::vec4(0.0f));
}

VisibilityBuffer::VisibilityBuffer() = default;

bool VisibilityBuffer::suits(const Maps& maps, const Canvas& canvas) {
    return maps.mesh.is("loaded") && canvas.depth_read_only().view.image->desc.samples == 1;
}

// [record]
void VisibilityBuffer::record(Frame& frame, const Scene& scene, const Maps& maps, const std::vector<Batch>& batches,
                              Canvas& canvas) {
    const Attachment seen = visibility_target(frame, seen_, canvas);
    std::vector<Batch> solid, holes;
    for (const Batch& batch : batches) (maps.has_holes(batch.item()) ? holes : solid).push_back(batch);
    frame.raster("visible", {.color = {seen}, .depth = canvas.depth_target(), .with = {maps}}, [&](Raster& pass) {
        maps.draw(pass, scene, solid, solid_.loaded, solid_.displaced);
        maps.draw(pass, scene, holes, holes_.loaded, holes_.displaced);
    });
}
// [/record]

void VisibilityBuffer::shade(Frame& frame, const Scene& scene, const Maps& maps, const std::vector<Batch>& batches,
                             Canvas& canvas, const Pipeline& pipeline, const std::vector<With>& with,
                             const std::vector<Resource>& reads) const {
    const ImageView color = canvas.color(frame);
    ComputeAccess access{.reads = reads, .writes = {color}, .with = with};
    access.reads.emplace_back(seen_);
    frame.compute("shade seen", access, [&](Compute& pass) {
        for (const Batch& batch : batches) {
            const DrawItem& item = batch.item();
            pass.use(pipeline, maps.variant(item)).set("visible", seen_, nearest_clamp).set("result", color);
            pass.set_if_present("ambient", scene.ambient());
            pass.set_if_present("instances", scene.instances);
            pass.set_if_present("materials", scene.materials);
            pass.set_if_present("map_placements", scene.placements);
            pass.set_if_present("vertices", item.model->vertices[item.mesh]);
            pass.set_if_present("indices", item.model->indices[item.mesh]);
            for (const auto& [name, buffers] : item.model->attributes) pass.set_if_present(name, buffers[item.mesh]);
            for (size_t slot = 0; slot < map_slot_count; ++slot)
                pass.set_if_present(map_slots()[slot].binding, scene.texture(item, static_cast<MapSlot>(slot)),
                                    item.maps.samplers[slot]);
            const Part& part = item.model->model.meshes[item.mesh].parts[item.part];
            pass.set("seen", glm::uvec3(batch.first, batch.count, part.first_index));
            pass.dispatch_threads(canvas.size());
        }
    });
}

std::vector<const Module*> VisibleSurfaces::dependencies() const {
    std::vector<const Module*> all = surfaces.dependencies();
    all.push_back(this);
    return all;
}

void VisibleSurfaces::draw(Frame& frame, const View& view, Canvas& canvas) {
    if (!shaded.is("visibility") || surfaces.shading.opaque || !VisibilityBuffer::suits(surfaces.maps, canvas))
        return surfaces.draw(frame, view, canvas);
    const Scene& scene = surfaces.scene();
    const std::vector<Batch> batches = surfaces.opaque_batches();
    seen_.record(frame, scene, surfaces.maps, batches, canvas);
    surfaces.lights.record(frame, scene, view, canvas.single_depth());
    seen_.shade(frame, scene, surfaces.maps, batches, canvas, shade_seen_, surfaces.given(), surfaces.shading.reads);
}

}  // namespace lightwalk
