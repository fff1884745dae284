// Motion of water from frame to frame.
#include <algorithm>
#include <utility>

#include "15_terrain_water/water.h"

namespace lightwalk {

void Water::Kept::begin_frame(Gpu&, glm::uvec2) { before = std::exchange(now, State()); }

bool Water::has_moved() const {
    const Kept::State &now = kept_.now, &before = kept_.before;
    if (now.method == Kept::none || now.method != before.method) return false;
    const bool has_waves = !method.is("flat") || (now.has_rings && before.has_rings);
    return (has_waves && now.time_s != before.time_s) || now.water.level_m != before.water.level_m;
}

// [draw_motion]
void Water::draw_motion(Frame& frame, const MotionPass& given) const {
    const WaterNow& water = kept_.before.water;
    WaterBefore before{.level_m = water.level_m, .waves = water.waves, .ring_phase = kept_.before.ring_phase};
    std::copy(std::begin(water.wave), std::end(water.wave), before.wave);
    for (int part = 0; part < 3; ++part)
        before.ocean[part] = ocean.travel(part, kept_.now.time_s - kept_.before.time_s);
    const bool fft = method.is("fft");
    const ImageView ocean_before = fft ? ImageView(ocean.moved_before()) : ImageView(black_).as_array();
    std::vector<Resource> reads{given.depth, black_};
    if (fft) reads.insert(reads.end(), {ocean.moved(), ocean.moved_before(), ocean.sloped()});
    frame.raster("motion of water", {.color = {keep(given.into)}, .reads = reads, .with = {*this}}, [&](Raster& pass) {
        pass.use(moved_, around_objects()).set("water_now", kept_.now.water).set("water_before", before);
        pass.set("depth", given.depth, nearest_clamp).set("from_to", given.from_to);
        pass.set_if_present("ocean_moved_before", ocean_before);
        pass.draw_indexed(rings_, 0, 6 * SPOKES * (RINGS - 1));
    });
}
// [/draw_motion]

}  // namespace lightwalk
