#include "15_terrain_water/shore.h"

namespace lightwalk {

Shore::Shore(Module& owner) : World(owner) {
    sky.map.change_default("plain");
    fog.method.change_default("none");
    water.method.change_default("none");
    light.method.change_default("mirror");
    light.radiance_alone = true;  // water looks along single directions
    water.tracer = &reflected;
    probe.update.change_default("moved");
    probe.distant = true;
    probe.in_use = light.in_use = [this] { return !water.method.is("none"); };
}

// [frame]
// Once for all views: the ground's levels, and the light that water reflects.
void Shore::record(Frame& frame) {
    ground.record(frame, false);
    if (light.in_use()) light.record(frame, scene());
}

// Before each view: shadows of houses and objects; the sky in a cube or the mirror image, as the water needs them.
void Shore::record_view(Frame& frame, const View& view) {
    sun_shadow.record(frame, view, scene(), drawings());
    if (water.sees_surroundings(view)) probe.record(frame, scene(), light, drawings());
    water.reflect(frame, view, drawings());
}

void Shore::draw_view(Frame& frame, const View& view, Canvas& canvas) {
    canvas.blended_by(&transparency);
    draw(frame, view, canvas, drawings());
}
// [/frame]

}  // namespace lightwalk
