// Lighting of a G-buffer: each light where it may reach.
#pragma once
#include "06_deferred/gbuffer.h"
#include "06_deferred/light_volumes.h"
#include "common/app/drawing.h"

namespace lightwalk {

class DeferredLights {
  public:
    /// From the G-buffer and the canvas's depth into its colour, every pixel with a surface. `with` are further
    /// modules of lighting: the lights, the G-buffer, the model of surfaces, and shadow casters. `ggx`: all surfaces
    /// are microfacets. `emits`: the colour holds the surfaces' emission, to which light is added.
    void record(Frame& frame, const Scene& scene, glm::vec3 ambient, const View& view, Canvas& canvas,
                const GBuffer& gbuffer, const Lights& lights, const std::vector<With>& with, bool ggx, bool emits);

    /// gbuffer.show instead of the picture.
    void show(Frame& frame, Canvas& canvas, const GBuffer& gbuffer);

    size_t volumes() const { return volumes_.count(); }

  private:
    LightVolumes volumes_;
    LightGrid tiles_;  ///< for its view: a tile's workgroup finds the tile in it
    const Macros all_{{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}};
    Pipeline full_screen_ = compute({.shader = "06_deferred/full_screen.comp", .macros = all_});
    Pipeline tiled_ = compute({.shader = "06_deferred/tiled.comp", .macros = all_});
    // [volume]
    // Back faces that lie behind the surface. They work with the camera inside, too, where there are no front faces.
    Pipeline volume_ = graphics({.vertex = "06_deferred/volume.vert",
                                 .fragment = "06_deferred/volume.frag",
                                 .cull = VK_CULL_MODE_FRONT_BIT,
                                 .depth_write = false,
                                 .depth_compare = Compare::less_or_equal,
                                 .depth_clamp = true,
                                 .blend = Blend::add,
                                 .macros = all_});
    // [/volume]
    Pipeline show_ = compute({.shader = "06_deferred/show.comp"});
};

}  // namespace lightwalk
