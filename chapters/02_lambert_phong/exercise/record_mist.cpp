// Exercise 02.record_mist: a frame of three passes, and what each says of its images.
// As it stands the scene is drawn before a black background, without sky and mist.
#include "02_lambert_phong/exercises.h"

namespace lightwalk::exercise {

// [record_mist]
// Records three passes, in this order:
//   "sky"    a compute pass, in which passes.sky fills its image `result`, frame.hdr: a dispatch for frame.size;
//   "shade"  a raster pass, in which passes.draw_scene(pass) draws over that, with depth in frame.depth;
//   "mist"   a compute pass, in which passes.mist fades what is far: its image `result` is frame.hdr, its texture
//   `depth`
//            is frame.depth, read with the sampler nearest_clamp; again for frame.size.
// Each pass says what it reads and writes, and of its targets whether they are cleared, kept or discarded. What is in
// the images when the frame begins is of the frame before, or of none: nothing of it may show. Depth is reversed, 0 is
// the farthest: what a depth target is cleared to. What a pass writes over wholly, and what a target discards, may hold
// anything: do not rely on it, and do not clear what is drawn over.
// [/record_mist]
void record_mist(Frame& frame, const MistPasses& passes) {
    // frame.compute("name", {.reads = {...}, .writes = {...}}, [&](Compute& pass) { ... }) records a compute pass. In
    // it, pass.use(pipeline).set("result", frame.hdr).dispatch_threads(frame.size) dispatches. A target that says
    // nothing is cleared; keep(...) and discard(...) say something (common/gpu/targets.h).
    frame.raster("shade", {.color = {frame.hdr}, .depth = frame.depth}, passes.draw_scene);
}

}  // namespace lightwalk::exercise
