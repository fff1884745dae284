// Islands world: mountains on a planet, in its air and fog.
#pragma once
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "common/app/world.h"

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

struct Islands : World {
    explicit Islands(Module& owner) : World(owner) { fog.method.change_default("none"); }

    Atmosphere atmosphere{*this, "atmosphere"};
    Planet planet{*this, "planet", atmosphere};
    Mountains mountains{*this, "mountains", atmosphere, planet};
    HeightFog fog{*this, "fog"};

    Drawings drawings() override { return {mountains, planet, atmosphere, fog}; }
    glm::vec4 background() const override { return {0.0f, 0.0f, 0.0f, 1.0f}; }  // space
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "film"}};
    }
};

}  // namespace lightwalk
