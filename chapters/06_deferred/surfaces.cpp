#include "06_deferred/surfaces.h"

namespace lightwalk {
namespace {

Pipeline::Graphics with_vertex(Pipeline::Graphics desc, const char* vertex) {
    desc.vertex = vertex;
    return desc;
}

}  // namespace

SurfacePipelines::SurfacePipelines(const Pipeline::Graphics& desc)
    : loaded(graphics(with_vertex(desc, "04_surface_maps/surface.vert"))),
      displaced(graphics(with_vertex(desc, "04_surface_maps/displaced.vert"))) {}

std::vector<Batch> glowing(const Scene& scene, const std::vector<Batch>& batches) {
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
        if (pixel.r >= 0.0f) sum += glm::dvec2(pixel), ++count;
    return count > 0 ? sum / count : sum;
}

}  // namespace lightwalk
