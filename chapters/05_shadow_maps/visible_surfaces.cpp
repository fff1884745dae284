#include "05_shadow_maps/visible_surfaces.h"

namespace lightwalk {

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
