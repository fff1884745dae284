#include "10_atmosphere/air_tables.h"

#include <algorithm>
#include <cmath>

#include "common/base/exercise.h"

namespace lightwalk {

bool AirTables::record(Frame& frame, const Module& owner, const Air& air, bool all_orders, float scale, bool always) {
    const auto ensure = [&](Image& image, const char* name, glm::vec2 size) {
        const glm::uvec2 scaled(glm::max(glm::vec2(2.0f), glm::round(scale * size)));
        if (image.ensure(frame.gpu.device, {.name = owner.path() + name, .size = scaled, .kept = true})) made_.forget();
    };
    ensure(transmittance_, " transmittance", {256, 64});
    ensure(multiple_, " multiple scattering", {32, 32});
    Air unit = air;
    unit.sun = glm::vec3(1.0f);
    if (made_.is_current(unit, all_orders, Exercises::epoch()) && !always) return false;
    frame.compute("transmittance table", {.writes = {transmittance_}, .with = {owner}}, [&](Compute& pass) {
        pass.use(make_transmittance_).set("air", air).set("result", transmittance_);
        pass.dispatch_threads(transmittance_.desc.size);
    });
    if (all_orders)
        frame.compute("multiple scattering table", {.reads = {transmittance_}, .writes = {multiple_}, .with = {owner}},
                      [&](Compute& pass) {
                          pass.use(make_multiple_).set("air", air);
                          pass.set("air_transmittance", transmittance_, linear_clamp);
                          pass.set("result", multiple_).dispatch(glm::uvec3(multiple_.desc.size, 1));
                      });
    return true;
}

void AirTables::set(Compute& pass) const {
    pass.set("air_transmittance", transmittance_, linear_clamp);
    pass.set_if_present("air_multiple", multiple_, linear_clamp);  // not wanted for single scattering
}

}  // namespace lightwalk
