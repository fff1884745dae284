// wrong: the depth is that of the frame before
#include "02_lambert_phong/exercises.h"

namespace lightwalk::exercise {

void record_mist(Frame& frame, const MistPasses& passes) {
    frame.compute("sky", {.writes = {frame.hdr}},
                  [&](Compute& pass) { pass.use(passes.sky).set("result", frame.hdr).dispatch_threads(frame.size); });
    frame.raster("shade", {.color = {keep(frame.hdr)}, .depth = keep(frame.depth)}, passes.draw_scene);
    frame.compute("mist", {.reads = {frame.depth, frame.hdr}, .writes = {frame.hdr}}, [&](Compute& pass) {
        pass.use(passes.mist).set("result", frame.hdr).set("depth", frame.depth, nearest_clamp);
        pass.dispatch_threads(frame.size);
    });
}

}  // namespace lightwalk::exercise
