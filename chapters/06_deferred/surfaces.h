// Pipelines that draw surfaces with chapter 04's maps.
#pragma once
#include "04_surface_maps/maps.h"
#include "common/image/image.h"

namespace lightwalk {

/// One fragment shader behind 04_surface_maps' vertex shaders.
struct SurfacePipelines {
    /// `desc` names the fragment shader and what else the two have in common.
    explicit SurfacePipelines(const Pipeline::Graphics& desc);
    Pipeline loaded, displaced;  ///< of the mesh; by Maps::mesh
};

/// What surfaces are drawn for.
struct SurfacePasses {
    SurfacePipelines depth{{.fragment = "04_surface_maps/depth.frag"}};
    Pipeline caster = graphics({.vertex = "04_surface_maps/surface.vert",
                                .fragment = "04_surface_maps/depth.frag",
                                .cull = VK_CULL_MODE_NONE,
                                .depth_clamp = true});
    SurfacePipelines forward{{.fragment = "05_shadow_maps/surface.frag"}};
    SurfacePipelines screen{
        {.fragment = "05_shadow_maps/surface.frag", .macros = {{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}}}};
    SurfacePipelines lost{{.fragment = "06_deferred/lost.frag"}};
    SurfacePipelines write{{.fragment = "06_deferred/write.frag"}};
    SurfacePipelines write_all{{.fragment = "06_deferred/write.frag", .cull = VK_CULL_MODE_NONE}};
    Pipeline write_culled = graphics({.vertex = "04_surface_maps/surface.vert",
                                      .geometry = "06_deferred/cull.geom",
                                      .fragment = "06_deferred/write.frag",
                                      .cull = VK_CULL_MODE_NONE});
    Pipeline write_left_out = graphics({.vertex = "04_surface_maps/surface.vert",
                                        .geometry = "06_deferred/cull.geom",
                                        .fragment = "06_deferred/write.frag",
                                        .cull = VK_CULL_MODE_NONE,
                                        .macros = {{"LEFT_OUT", "1"}}});
    // A little nearer: behind a geometry shader a device may compute depth otherwise in the last bit.
    SurfacePipelines glow{{.fragment = "06_deferred/glow.frag",
                           .depth_write = false,
                           .depth_bias = {.constant = 16},
                           .blend = Blend::add}};
};

/// Those of the batches that have something in them that emits.
std::vector<Batch> glowing(const Scene& scene, const std::vector<Batch>& batches);

/// Of a picture of what a G-buffer loses: degrees of normals, millimetres of positions, in the mean over what is drawn.
glm::vec2 mean_loss(const ImageRgb& picture);

}  // namespace lightwalk
