#include <algorithm>

#include "14_environment/exercises.h"

namespace lightwalk::solution {

void prefilter_faces(Frame& frame, const PrefilterPasses& passes) {
    const Image& cube = passes.prefiltered;
    const ComputeAccess access{.reads = {passes.radiance}, .writes = {cube}, .with = passes.with};
    frame.compute("prefilter", access, [&](Compute& pass) {
        pass.use(passes.filter).set("radiance", passes.radiance, linear_clamp);
        for (uint32_t m = 0; m < cube.desc.mips; ++m)
            for (uint32_t face = 0; face < 6; ++face) {
                const ImageView level = cube.face(face).mip(m);
                const float roughness = static_cast<float>(m) / static_cast<float>(std::max(cube.desc.mips, 2u) - 1);
                pass.set("face_level", level).set("face_now", FaceNow{face, roughness});
                pass.dispatch_threads(glm::uvec2(level.size()));
            }
    });
}

}  // namespace lightwalk::solution
