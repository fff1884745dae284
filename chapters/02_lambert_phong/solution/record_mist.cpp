#include "02_lambert_phong/exercises.h"

namespace lightwalk::solution {

void record_mist(Frame& frame, const MistPasses& passes) {
    frame.compute("sky", {.writes = {frame.hdr}},
                  [&](Compute& pass) { pass.use(passes.sky).set("result", frame.hdr).dispatch_threads(frame.size); });
    frame.raster("shade", {.color = {keep(frame.hdr)}, .depth = clear(frame.depth, 0.0f)}, passes.draw_scene);
    frame.compute("mist", {.reads = {frame.depth, frame.hdr}, .writes = {frame.hdr}}, [&](Compute& pass) {
        pass.use(passes.mist).set("result", frame.hdr).set("depth", frame.depth, nearest_clamp);
        pass.dispatch_threads(frame.size);
    });
}

}  // namespace lightwalk::solution
