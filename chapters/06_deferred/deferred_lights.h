// Lighting of a G-buffer: each light where it may reach.
#pragma once
#include "03_attenuation/lights.h"
#include "06_deferred/exercises.h"
#include "06_deferred/gbuffer.h"
#include "06_deferred/light_volume_data.h"
#include "common/app/drawing.h"
#include "common/base/epoch.h"

namespace lightwalk {

/// Triangle corners, counter-clockwise from outside; the mesh encloses the unit shape.
std::vector<glm::vec3> volume_mesh(LightVolume::Shape shape);

class LightVolumes {
  public:
    /// Uploads volumes if the lights, their reach or the exercise's toggle have changed.
    void update(Frame& frame, const Lights& lights);

    /// Draws each light's volume; the current pipeline reads `corners` and `volumes`.
    void draw(Raster& pass) const;

    Buffer without;  ///< number of lights without a volume, then their indices, ascending
    size_t count() const { return spheres_ + cones_; }

  private:
    Buffer sphere_, cone_, volumes_;  ///< spheres first, then cones
    uint32_t sphere_corners_ = 0, cone_corners_ = 0, spheres_ = 0, cones_ = 0;
    Fingerprint made_;
};

class DeferredLights {
  public:
    /// Updates light volumes, or lays out the view's tiles.
    void update(Frame& frame, const Scene& scene, const View& view, const GBuffer& gbuffer, const Lights& lights);
    bool has_volumes() const { return has_volumes_; }
    /// Ambient light, and lights without a volume, for every pixel. `emits`: `color` holds emission, to which it is added.
    void light_pixels(Compute& pass, const ImageView& color, glm::vec3 ambient, glm::vec3 background, bool ggx,
                      bool emits) const;
    /// Each other light, where its volume covers a surface.
    void light_volumes(Raster& pass, bool ggx) const;

    /// Both, from the G-buffer and the canvas's depth into its colour, every pixel with a surface. `with` are further
    /// modules of lighting: the lights, the G-buffer, the model of surfaces, and shadow casters. `ggx`: all surfaces
    /// are microfacets. `emits`: the colour holds the surfaces' emission, to which light is added.
    void record(Frame& frame, const Scene& scene, glm::vec3 ambient, const View& view, Canvas& canvas,
                const GBuffer& gbuffer, const Lights& lights, const std::vector<With>& with, bool ggx, bool emits);

    /// Picture of the channel gbuffer.show.
    void show(Frame& frame, Canvas& canvas, const GBuffer& gbuffer);

    size_t volumes() const { return volumes_.count(); }

  private:
    LightVolumes volumes_;
    bool is_tiled_ = false, has_volumes_ = false;
    LightGrid tiles_;  ///< layout only; workgroups list their lights themselves
    const Macros all_{{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}};
    Pipeline full_screen_ = compute({.shader = "06_deferred/full_screen.comp", .macros = all_});
    Pipeline tiled_ = compute({.shader = "06_deferred/tiled.comp", .macros = all_});
    // [volume]
    // Back faces behind the surface, which also work with the camera inside, where there are no front faces.
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
