// Street world: chapter 06's lights in upright strips, each drawn by another method.
#pragma once
#include "06_deferred/many_lights.h"

namespace lightwalk {

struct Street : ManyLights {
    using ManyLights::ManyLights;

  protected:
    void draw_view(Frame& frame, const View& view, Canvas& canvas) override;

  private:
    DerivedViews views_;
    Image colors_[4], depths_[4];
    Pipeline join_ = compute({.shader = "19_ambiance/strips.comp"});
};

}  // namespace lightwalk
