// Exercise 02.record_mist: a frame of three passes, and the images that each reads and writes.
// Starter: the scene is drawn on a black background, without sky and mist.
#include "02_lambert_phong/exercises.h"

namespace lightwalk::exercise {

// [record_mist]
// Records three passes, in this order:
//     "sky"    a compute pass: passes.sky fills its image `result`, bound to frame.hdr.
//     "shade"  a raster pass: passes.draw_scene(pass) draws over the sky in frame.hdr, with
//              frame.depth as depth target.
//     "mist"   a compute pass: passes.mist fades what is far. Its image `result` is frame.hdr;
//              its texture `depth` is frame.depth, sampled with nearest_clamp.
// Both compute passes dispatch one thread for each pixel of frame.size. Each pass states
// the images it reads and writes, and a raster pass states for each target whether it is
// cleared, kept or discarded.
// When the frame begins, the images hold the previous frame, or nothing defined; none of it
// may show. Depth is reversed: 0 is the farthest depth, to which a depth target is cleared.
// An image whose content was discarded, or that a pass overwrites completely, may hold
// anything before: do not rely on it. Do not clear an image that already holds part of this
// frame's picture.
// [/record_mist]
void record_mist(Frame& frame, const MistPasses& passes) {
    // frame.compute("name", {.reads = {...}, .writes = {...}}, [&](Compute& pass) { ... }) records a compute pass. In
    // it, pass.use(pipeline).set("result", frame.hdr).dispatch_threads(frame.size) dispatches. A target that says
    // nothing is cleared; keep(...) and discard(...) say something (common/gpu/targets.h).
    frame.raster("shade", {.color = {frame.hdr}, .depth = frame.depth}, passes.draw_scene);
}

}  // namespace lightwalk::exercise
