#include "14_environment/paint.h"

#include "common/app/settings.h"
#include "common/base/exercise.h"

namespace lightwalk {

void CarPaint::record(Frame& frame) {
    if (made_.is_current(epoch())) return;
    frame.compute("paint table", {.writes = {table}, .with = {*this}},
                  [&](Compute& pass) { pass.use(fill_).set("table", table).dispatch_threads(table.desc.size); });
}

void CarPaint::bind(Pass& pass) const { pass.set_if_present("paint_table", table, linear_clamp); }

}  // namespace lightwalk
