// Exercise 14.prefilter_faces: the levels of a cube, each written through a view of one face of one level.
// Starter: only the first level of the face +x is written.
#include "14_environment/exercises.h"

namespace lightwalk::exercise {

// [prefilter_faces]
// Records one compute pass, "prefilter", that fills every face of every level of the cube
// passes.prefiltered. The pass reads passes.radiance, writes passes.prefiltered, and its
// .with is passes.with. Its pipeline, passes.filter, has
//
//     radiance      a cube texture: passes.radiance, with linear_clamp
//     face_level    an image of one layer: the texels of one face of one level, a view of
//                   passes.prefiltered
//     face_now      a FaceNow: which face it is, 0 to 5, and the level's roughness
//
// and wants a thread for each texel of face_level. The roughness rises evenly from 0 in
// level 0 to 1 in the last level; a cube of one level has roughness 0.
// passes.prefiltered.desc.mips is the number of levels; cube.face(f).mip(m) is
// a view, and .size() of a view is in texels. No dispatch reads what another has written.
// [/prefilter_faces]
void prefilter_faces(Frame& frame, const PrefilterPasses& passes) {
    const ComputeAccess access{.reads = {passes.radiance}, .writes = {passes.prefiltered}, .with = passes.with};
    frame.compute("prefilter", access, [&](Compute& pass) {
        pass.use(passes.filter).set("radiance", passes.radiance, linear_clamp);
        const ImageView level = passes.prefiltered.face(0).mip(0);
        pass.set("face_level", level).set("face_now", FaceNow{0, 0.0f});
        pass.dispatch_threads(glm::uvec2(level.size()));
    });
}

}  // namespace lightwalk::exercise
