#include "common/app/world.h"

#include <utility>

namespace lightwalk {

Drawings World::prepare_view(Frame& frame, const View& view) {
    if (std::exchange(begun_, frame.number()) != frame.number()) {
        scene_->forget_sun();  // may belong to a drawing no longer in use
        update(frame, in_order(drawings()));
        record(frame);
    }
    record_view(frame, view);
    return drawings();
}

void World::draw_light(Frame& frame, const View& view, Canvas& canvas) {
    const ViewScope scope(frame, view);
    prepare_view(frame, view);
    draw_view(frame, view, canvas);
}

void set_look(const World& world, const Module& shown_by) {
    const KnobList& knobs = shown_by.all_knobs();
    for (const auto& [name, value] : world.look()) find_knob(knobs, name).change_default(value);
}

}  // namespace lightwalk
