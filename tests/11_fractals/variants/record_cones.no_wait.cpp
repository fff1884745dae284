// wrong: validation says
#include "11_fractals/exercises.h"

namespace lightwalk::exercise {

void record_cones(Frame& frame, const ConePasses& passes) {
    const ComputeAccess access{.reads = {passes.starts}, .writes = {passes.starts, passes.found}, .with = passes.with};
    frame.compute("julia march", access, [&](Compute& pass) {
        pass.use(passes.cone).set("starts", passes.starts).dispatch_threads(passes.starts.desc.size);
        pass.use(passes.march).set("starts", passes.starts, nearest_clamp).set("found", passes.found);
        pass.dispatch_threads(passes.found.desc.size);
    });
}

}  // namespace lightwalk::exercise
