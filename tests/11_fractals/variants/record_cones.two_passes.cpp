// wrong: the compute passes are "julia cones, julia march"
#include "11_fractals/exercises.h"

namespace lightwalk::exercise {

void record_cones(Frame& frame, const ConePasses& passes) {
    frame.compute("julia cones", {.writes = {passes.starts}, .with = passes.with}, [&](Compute& pass) {
        pass.use(passes.cone).set("starts", passes.starts).dispatch_threads(passes.starts.desc.size);
    });
    frame.compute("julia march", {.reads = {passes.starts}, .writes = {passes.found}, .with = passes.with},
                  [&](Compute& pass) {
                      pass.use(passes.march).set("starts", passes.starts, nearest_clamp).set("found", passes.found);
                      pass.dispatch_threads(passes.found.desc.size);
                  });
}

}  // namespace lightwalk::exercise
