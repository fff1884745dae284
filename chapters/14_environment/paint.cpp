#include "14_environment/paint.h"

namespace lightwalk {

void CarPaint::record(Frame& frame) {
    std::string now;
    for (const KnobBase* knob : all_knobs()) now += knob->text() + " ";
    if (now == made_) return;
    frame.compute("paint table", {.writes = {table}, .with = {*this}},
                  [&](Compute& pass) { pass.use(fill_).set("table", table).dispatch_threads(table.desc.size); });
    made_ = now;
}

void CarPaint::bind(Pass& pass) const { pass.offer("paint_table", table, linear_clamp); }

}  // namespace lightwalk
