// Exercise 11.record_cones: two dispatches of one pass, the second of which reads the result of the first.
// Starter: no cone is marched: `starts` holds what the frame put there, and rays begin behind the set.
#include "11_fractals/exercises.h"

namespace lightwalk::exercise {

// [record_cones]
// Records one compute pass called "julia march" with two dispatches.
// - First passes.cone, which writes its image `starts`: one thread per texel of
//   passes.starts.
// - Then passes.march, which reads that image as its texture `starts` with the sampler
//   nearest_clamp, and writes its image `found`: one thread per texel of passes.found.
//
// The pass declares what it reads (.reads) and writes (.writes); an image that it both
// reads and writes appears in both lists. Its .with is passes.with.
//
// Dispatches of one pass may run at the same time or in any order. pass.wait() makes
// the results of all earlier dispatches visible to the following ones.
// [/record_cones]
void record_cones(Frame& frame, const ConePasses& passes) {
    frame.compute("julia march", {.reads = {passes.starts}, .writes = {passes.found}, .with = passes.with},
                  [&](Compute& pass) {
                      pass.use(passes.march).set("starts", passes.starts, nearest_clamp).set("found", passes.found);
                      pass.dispatch_threads(passes.found.desc.size);
                  });
}

}  // namespace lightwalk::exercise
