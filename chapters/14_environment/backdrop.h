// The environment's picture behind everything else, as a drawing.
#pragma once
#include "05_shadow_maps/casting.h"
#include "14_environment/ground_shadow.h"
#include "14_environment/image_light.h"

namespace lightwalk {

// [backdrop]
/// Draws before all others: it overwrites the whole canvas. A scene without a picture keeps its background.
struct Backdrop : Drawing {
    Backdrop(Module& owner, std::string name, const ImageLight& light)
        : Drawing(owner, std::move(name)), light_(light) {}

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
    // [/backdrop]

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
