// A scene's objects in the light of their surroundings, as a drawing.
#pragma once
#include "05_shadow_maps/lit_scene.h"
#include "05_shadow_maps/rays.h"
#include "14_environment/image_light.h"
#include "14_environment/paint.h"
#include "14_environment/screen_occlusion.h"
#include "14_environment/substances.h"

namespace lightwalk {

// [lit_around]
/// LitScene with an ImageLight as ambient light: the owner records the ImageLight before drawing.
struct LitAround : Drawing, ItemCaster {
    LitAround(Module& owner, std::string name, const ImageLight& light);

    LitScene lit;
    SurfaceScene& surfaces = lit.surfaces;
    Maps& maps = lit.maps;
    Shading& shading = lit.shading;

    Choice occlusion{*this,
                     "occlusion",
                     {"none", "screen_space", "rays"},
                     "none",
                     "Occlusion of environment light: ignored; found in the depth buffer (screen_space); or by a ray "
                     "for each sample, for diffuse light and for the reflection 'sampled'"};
    ScreenOcclusion screen_occlusion;
    Substances substances;
    CarPaint paint;
    SceneRays rays;

    void find_casters(const Drawings& drawings) override { lit.find_casters(drawings); }
    std::vector<const Module*> dependencies() const override;
    void update(Frame& frame) override;
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    const Drawing* transparent_source() const override { return &surfaces; }
    const Maps& cut_by() const override { return maps; }
    // [/lit_around]

  private:
    SurfacePipelines surface_{{.fragment = "14_environment/surface.frag"}};
    Pipeline seen_ = compute({.shader = "14_environment/surface_seen.comp"});
    SurfacePipelines occluded_{{.fragment = "14_environment/surface.frag",
                                .macros = Macros{{"OCCLUDED", "1"}}.replace_file("14_environment/unoccluded.glsl",
                                                                                 "14_environment/occluded.glsl")}};
    Pipeline occluded_seen_ = compute({.shader = "14_environment/surface_seen.comp",
                                       .macros = Macros{{"OCCLUDED", "1"}}.replace_file(
                                           "14_environment/unoccluded.glsl", "14_environment/occluded.glsl")});
    SurfacePipelines screen_occluded_{{.fragment = "14_environment/surface.frag",
                                       .macros = Macros{{"SCREEN_OCCLUDED", "1"}}.replace_file(
                                           "14_environment/all_open.glsl", "14_environment/screen_occlusion.glsl")}};
    SurfacePipelines glass_ =
        see_through("14_environment/surface.frag", {{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}});
};

}  // namespace lightwalk
