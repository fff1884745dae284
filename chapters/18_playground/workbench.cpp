#include "18_playground/workbench.h"

#include <optional>

#include "common/app/knob_scope.h"

namespace lightwalk {

Workbench::Workbench(Module& owner) : World(owner) {
    objects.gbuffer.method.change_default("forward");
    objects.maps.method.change_default("normal");
    objects.culling.method.change_default("occlusion");
    objects.culling.least.change_default("4000");
    objects.shading.with = {light, substances, paint};
    objects.surfaces.all_lights = [this](const Frame& frame) { return all_lights(frame); };
    sky.map.change_default("plain");
    water.method.change_default("none");
    fog.method.change_default("none");
    atmosphere.in_use = sky.in_use = [this] { return air.is("sky"); };
    backdrop.in_use = [this] { return !air.is("sky"); };
    land.in_use = sun_shadow.in_use = [this] { return air.is("sky") && ground.exists(); };
    water.in_use = [this] { return !water.method.is("none"); };
}

LightList Workbench::all_lights(const Frame& frame) {
    return all_lights_.from(scene().lights(), scene().bounds, scattered, frame.seed);
}

// [workbench_record]
void Workbench::record(Frame& frame) {
    light.record(frame, scene());
    paint.record(frame);
    // A sky has its sun: reflections show this sky instead of the scene's environment. In a room they may show the room.
    probe.distant = air.is("sky");
    std::optional<KnobScope> follows;
    if (probe.distant && probe.update.is("off")) follows.emplace(probe.update, "moved");
    probe.record(frame, scene(), light, {backdrop, objects, sky, atmosphere});
}
// [/workbench_record]

void Workbench::record_view(Frame& frame, const View& view) {
    if (land.in_use()) {
        ground.record(frame, false);
        sun_shadow.record(frame, view, scene(), drawings());
    }
    water.reflect(frame, view, drawings());
}

}  // namespace lightwalk
