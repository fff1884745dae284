// Exercise 11.record_cones: two dispatches of one pass, the second of which needs what the first has written.
// As it stands no cone is marched: rays begin wherever the image `starts` happens to say.
#include "11_fractals/exercises.h"

namespace lightwalk::exercise {

// [record_cones]
// Records one compute pass, "julia march", of two dispatches: passes.cone writes its image `starts`, a thread for each
// of its texels; passes.march reads that as its texture `starts`, with nearest_clamp, and writes its image `found`, a
// thread for each texel again. The pass says what it reads and writes (what stands in both lists is both), and .with is
// passes.with. Dispatches of one pass run at the same time, or in any order: pass.wait() makes what follows see what
// was written before.
// [/record_cones]
void record_cones(Frame& frame, const ConePasses& passes) {
    frame.compute("julia march", {.reads = {passes.starts}, .writes = {passes.found}, .with = passes.with},
                  [&](Compute& pass) {
                      pass.use(passes.march).set("starts", passes.starts, nearest_clamp).set("found", passes.found);
                      pass.dispatch_threads(passes.found.desc.size);
                  });
}

}  // namespace lightwalk::exercise
