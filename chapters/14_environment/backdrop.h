// The environment's picture behind everything else, as a drawing.
#pragma once
#include "05_shadow_maps/casting.h"
#include "05_shadow_maps/rays.h"
#include "14_environment/ground_shadow_data.h"
#include "14_environment/image_light.h"
#include "common/base/epoch.h"

namespace lightwalk {

/// A map of the ground below the scene: of each place the share of the light from all around that is not hidden, found by
/// chapter 05's rays. record() in each frame; it does nothing where nothing has moved.
struct GroundShadow : Module {
    GroundShadow(Module& owner, std::string name);

    Knob<int> directions{*this,
                         "directions",
                         96,
                         {1, 1024},
                         "Directions that stand for the environment, each for an equal share of light"};
    Knob<int> resolution{*this, "resolution", 128, {8, 1024}, "Width and height of the map", "texels"};
    SceneRays rays{*this, "rays"};
    Image arriving;  ///< made by record()

    void prepare(Gpu& gpu, Scene& scene) override;
    /// `maps`: those that cut holes into what stands there; null: holes by an alpha below 0.5, at rest.
    void record(Frame& frame, const Scene& scene, const Maps* maps, const EnvironmentScale& turn, float ground_y);
    const GroundShadowState& state() const { return state_; }

  private:
    std::shared_ptr<Image> environment_;  ///< that picture_ is of
    ImageRgb picture_;
    GroundShadowState state_{};
    Fingerprint made_;
    Buffer lights_;
    Pipeline trace_ = compute({.shader = "14_environment/ground_shadow.comp"});
};

/// So many directions, each of which stands for the same share of the light (its luminance times the cosine to +y) that
/// an equirectangular picture sends down: turned as `turn` says.
std::vector<GroundLight> ground_lights(const ImageRgb& picture, const EnvironmentScale& turn, int count);

/// Draws before all others: it overwrites the whole canvas. A scene without a picture keeps its background.
struct Backdrop : Drawing {
    Backdrop(Module& owner, std::string name, const ImageLight& light);

    Choice ground{*this,
                  "ground",
                  {"none", "projected"},
                  "none",
                  "Lower half of the picture: infinitely far away like the rest, or projected on a horizontal plane"};
    Knob<float> ground_y{*this, "ground_y", 0.0f, {-1e4f, 1e4f}, "Height of that plane", "m"};
    Knob<float> camera_m{
        *this, "camera_m", 1.6f, {0.1f, 100.0f}, "Height above the plane from which the picture was taken", "m"};
    Knob<float> radius_m{*this,
                         "radius_m",
                         14.0f,
                         {0.1f, 1e4f},
                         "Radius around the origin within which the ground is projected; a dome stands on its edge",
                         "m"};
    Knob<float> level{*this, "level", 0.0f, {0.0f, 8.0f}, "Level of the picture that is shown; 0 is sharp", "levels"};
    GroundShadow shadow{*this, "shadow"};

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }
    Phase draw_phase() const override { return Phase::backdrop; }
    std::vector<const Module*> dependencies() const override { return {this, &light_}; }
    void find_casters(const Drawings& drawings) override { cut_by_ = Casting(drawings).maps(); }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

  private:
    const ImageLight& light_;
    const Scene* scene_ = nullptr;
    const Maps* cut_by_ = nullptr;
    Pipeline fill_ = compute({.shader = "14_environment/backdrop.comp"});
};

}  // namespace lightwalk
