// Outlines world: five pictures full of edges, one at a time.
#pragma once
#include "11_fractals/julia.h"
#include "11_fractals/terrain.h"
#include "12_skin/head.h"
#include "common/app/drawing.h"
#include "common/app/world.h"

namespace lightwalk {

struct HalfPlane : Drawing {
    HalfPlane(Module& owner, std::string name) : Drawing(owner, std::move(name), "half_plane") {}
    Knob<float> angle_deg{
        *this, "angle_deg", 8.0f, {-360.0f, 360.0f}, "Angle of the line, counter-clockwise from the right", "deg"};
    Knob<float> offset{
        *this, "offset", 0.0f, {-4096.0f, 4096.0f}, "Distance of the line from the middle of the picture", "px"};

    /// Every pixel, with one sample.
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

  private:
    Pipeline fill_ = compute({.shader = "13_mlaa/half_plane.comp"});
};

struct Outlines : World {
    explicit Outlines(Module& owner);

    LitScene objects{*this, "objects", Shading{.opaque = &surface_, .seen = &seen_, .transparent = &glass_}};
    HalfPlane half_plane{*this, "half_plane"};
    Choice subject{*this,
                   "world",
                   {"objects", "julia", "terrain", "head", "half_plane"},
                   "objects",
                   "Picture to filter: the objects of the scene; a Julia set or landscape of chapter 11; the head of "
                   "chapter 12; or a half-plane of black and white"};
    Choice clip{*this,
                "clip",
                {"before", "after"},
                "before",
                "Clipping of light brighter than white: before or after pixels are mixed"};
    EnvironmentLight environment{*this, "environment"};
    Julia julia{*this, "julia", environment};
    Terrain terrain{*this, "terrain"};
    Head head{*this, "head", objects, environment};

    /// False: the picture is one of several, and the owner calls clip_light() with their mean.
    bool clips = true;
    void clip_light(Frame& frame, const ImageView& light) const;

    /// Whether triangles are drawn, which can be rasterised with several samples per pixel.
    bool has_triangles() const { return subject.is("objects"); }

    Drawings drawings() override { return {subjects_[subject.index]}; }
    Eye eye(const Frame& frame, const Camera& given) override {
        return subject.is("terrain") ? terrain.eye(given, frame.time_s) : Eye{given};
    }
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "off"}};
    }

  protected:
    void draw_view(Frame& frame, const View& view, Canvas& canvas) override;

  private:
    const Drawings subjects_{objects, julia, terrain, head, half_plane};
    const SurfacePipelines surface_{{.fragment = "13_mlaa/surface.frag"}};
    const Pipeline seen_ = compute({.shader = "13_mlaa/surface_seen.comp"});
    const SurfacePipelines glass_ =
        see_through("13_mlaa/surface.frag", {{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}});
    Pipeline clip_ = compute({.shader = "13_mlaa/clip.comp"});
};

}  // namespace lightwalk
