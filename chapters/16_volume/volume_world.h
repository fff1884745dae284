// Volume world: a volume, and solid objects seen through a lens.
#pragma once
#include "05_shadow_maps/visibility_buffer.h"
#include "09_post_effects/depth_of_field.h"
#include "16_volume/finish.h"
#include "16_volume/volume.h"
#include "common/app/world.h"

namespace lightwalk {

struct VolumeWorld : World {
    explicit VolumeWorld(Module& owner) : World(owner) { objects.maps.method.change_default("flat"); }

    Finish finish{*this, "finish"};  // before the maps' levels are made of it
    SurfaceScene objects{*this, "objects"};
    VisibleSurfaces seen{*this, "objects", objects};
    Volume volume{*this, "volume"};
    DepthOfField dof{*this, "dof"};

    Drawings drawings() override { return {seen, volume}; }

  protected:
    // Objects alone write depth, so the lens blurs them alone. The volume is drawn after it: it stays sharp, and its rays
    // end at the objects.
    void draw_view(Frame& frame, const View& view, Canvas& canvas) override {
        dof.record(frame, view, canvas, {seen});
        draw(frame, view, canvas, {volume});
    }
};

}  // namespace lightwalk
