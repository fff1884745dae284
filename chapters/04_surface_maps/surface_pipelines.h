// Pipelines that draw surfaces with this chapter's maps.
#pragma once
#include "04_surface_maps/maps.h"

namespace lightwalk {

/// One fragment shader behind this chapter's two vertex shaders.
struct SurfacePipelines {
    /// `desc` has the fragment shader and the common state of the two.
    explicit SurfacePipelines(const Pipeline::Graphics& desc)
        : loaded(graphics(with_vertex(desc, "04_surface_maps/surface.vert"))),
          displaced(graphics(with_vertex(desc, "04_surface_maps/displaced.vert"))) {}
    Pipeline loaded, displaced;  ///< of the mesh; by Maps::mesh

  private:
    static Pipeline::Graphics with_vertex(Pipeline::Graphics desc, const char* vertex) {
        desc.vertex = vertex;
        return desc;
    }
};

}  // namespace lightwalk
