// Mountains on the planet: the models of the scene, lit by the sun and the sky.
#pragma once
#include "10_atmosphere/planet.h"

namespace lightwalk {

struct Mountains : Drawing {
    Mountains(Module& owner, std::string name, const Atmosphere& atmosphere, const Planet& planet)
        : Drawing(owner, std::move(name)), atmosphere_(atmosphere), planet_(planet) {}

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }
    const Drawing* sun_source() const override { return &atmosphere_; }
    std::vector<const Module*> dependencies() const override { return {this, &atmosphere_, &planet_}; }
    void draw(Frame& frame, const View&, Canvas& canvas) override {
        frame.raster("mountains",
                     {.color = {canvas.color_target()}, .depth = canvas.depth_target(), .with = {atmosphere_, planet_}},
                     [&](Raster& pass) { pass.use(surface_).draw(*scene_); });
    }

  private:
    const Atmosphere& atmosphere_;
    const Planet& planet_;
    const Scene* scene_ = nullptr;
    Pipeline surface_ = graphics({.vertex = "01_obj/mesh.vert", .fragment = "10_atmosphere/surface.frag"});
};

}  // namespace lightwalk
