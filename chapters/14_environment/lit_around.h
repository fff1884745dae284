// A scene's objects in the light of their surroundings, as a drawing.
#pragma once
#include "05_shadow_maps/lit_scene.h"
#include "05_shadow_maps/rays.h"
#include "14_environment/image_light.h"
#include "14_environment/paint.h"
#include "common/app/module.h"
#include "common/scene/view.h"

namespace lightwalk {

/// Gives shaders screen_occlusion() of 14_environment/screen_occlusion.glsl: of each pixel the share of directions, by
/// their cosine, in which the depth buffer shows nothing within `radius_m`, and their mean direction. record() once a
/// view, when its depth is there and before its surfaces are shaded. (J. Jimenez et al., "Practical real-time strategies
/// for accurate indirect occlusion", SIGGRAPH course, 2016.)
struct ScreenOcclusion : Module {
    ScreenOcclusion(Module& owner, std::string name);

    Knob<float> radius_m{*this, "radius_m", 1.0f, {0.01f, 100.0f}, "Distance within which surfaces hide light", "m"};
    Knob<int> slices{*this, "slices", 3, {1, 64}, "Planes through the line of sight in which horizons are sought"};
    Knob<int> steps{*this, "steps", 8, {1, 64}, "Depths that are read to each side of a slice"};
    Knob<float> thickness{
        *this,
        "thickness",
        0.1f,
        {0.0f, 1.0f},
        "Thinness of objects: share of the way that a horizon falls again over one radius behind what raised it"};
    Choice resolution{
        *this, "resolution", {"half", "full"}, "half", "Pixels in which horizons are sought: one of four, or each"};
    Choice specular{
        *this,
        "specular",
        {"visibility", "cone"},
        "cone",
        "Occlusion of reflections: the visibility as for diffuse light, or the part of the lobe inside of the "
        "cone around the bent normal"};

    void record(Frame& frame, const View& view, const ImageView& depth);
    const Image& image() const { return wide_; }
    std::vector<Resource> reads() const override;
    void bind(Pass& pass) const override;

  private:
    Image found_, wide_;  ///< RGBA16F: bent normal less normal, world space; visibility. As found, per pixel
    Pipeline seek_ = compute({.shader = "14_environment/screen_occlusion.comp"});
    Pipeline widen_ = compute({.shader = "14_environment/widen_occlusion.comp"});
};

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
    const TransparentSource* transparent_source() const override { return &surfaces; }
    const Maps& cut_by() const override { return maps; }

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
