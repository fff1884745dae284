// Terrain drawing: ground from a height map.
#pragma once
#include "10_atmosphere/atmosphere.h"
#include "common/app/drawing.h"

namespace lightwalk {

// [land]
/// Ground from a height map, lit by the sun and the sky of an atmosphere.
struct Land : Drawing {
    Land(Module& owner, std::string name, const Atmosphere& atmosphere)
        : Drawing(owner, std::move(name), "land"), atmosphere_(atmosphere) {}

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    // [/land]

  private:
    const Atmosphere& atmosphere_;
    const Scene* scene_ = nullptr;
};

}  // namespace lightwalk
