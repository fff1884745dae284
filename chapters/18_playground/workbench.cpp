#include "18_playground/workbench.h"

#include "03_attenuation/scattered_lights.h"

namespace lightwalk {

Workbench::Workbench(Module& owner) : World(owner) {
    objects.gbuffer.method.change_default("forward");
    objects.maps.method.change_default("normal");
    objects.shading = &surface_;
    objects.shaded.reset();
    objects.transparent_shading = &glass_;
    objects.writing = &write_, objects.rest = &rest_;
    objects.shading_with = {light, substances, paint};
    objects.all_lights = [this](const Frame& frame) { return all_lights(frame); };
    backdrop.shadow.maps = &objects.maps;
    sky.map.change_default("plain");
    water.method.change_default("none");
    fog.method.change_default("none");
    probe.update.change_default("moved");
    probe.distant = true;
    atmosphere.in_use = sky.in_use = probe.in_use = [this] { return air.is("sky"); };
    backdrop.in_use = [this] { return !air.is("sky"); };
    water.in_use = [this] { return !water.method.is("none"); };
}

std::vector<Light> Workbench::all_lights(const Frame& frame) {
    std::vector<Light> all = scene().lights();
    const std::vector<Light> more = scatter_lights(scene().bounds, scattered, frame.seed);
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

// [workbench_record]
void Workbench::record(Frame& frame) {
    light.record(frame, scene());
    paint.record(frame);
    // A sky has its sun: reflections show this sky instead of the scene's environment.
    if (probe.in_use()) probe.record(frame, scene(), light, drawings());
}
// [/workbench_record]

}  // namespace lightwalk
