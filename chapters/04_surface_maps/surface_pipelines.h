// Pipelines that draw surfaces with this chapter's maps.
#pragma once
#include "04_surface_maps/maps.h"

namespace lightwalk {

/// Pipelines of one fragment shader with this chapter's two vertex shaders.
struct SurfacePipelines {
    /// `desc`: fragment shader and common state.
    explicit SurfacePipelines(const Pipeline::Graphics& desc)
        : loaded(graphics(with_vertex(desc, "04_surface_maps/surface.vert"))),
          displaced(graphics(with_vertex(desc, "04_surface_maps/displaced.vert"))) {}
    Pipeline loaded, displaced;  ///< by Maps::mesh

  private:
    static Pipeline::Graphics with_vertex(Pipeline::Graphics desc, const char* vertex) {
        desc.vertex = vertex;
        return desc;
    }
};

}  // namespace lightwalk
