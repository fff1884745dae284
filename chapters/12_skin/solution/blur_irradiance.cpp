#include <algorithm>
#include <cmath>

#include "12_skin/exercises.h"

namespace lightwalk::solution {

void blur_irradiance(Frame& frame, const BlurPasses& passes) {
    ComputeAccess access{.reads = {passes.irradiance, passes.stretch, passes.between}, .writes = {passes.between}};
    for (const Image* level : passes.levels) {
        access.reads.push_back(*level);
        access.writes.push_back(*level);
    }
    frame.compute("skin blur", access, [&](Compute& pass) {
        const auto line = [&](const Image& from, const Image& into, glm::ivec2 direction, glm::vec3 done,
                              glm::vec3 variance) {
            pass.use(passes.line).set("from", from, nearest_clamp).set("into", into);
            pass.set("stretch", passes.stretch, nearest_clamp);
            pass.set("blur", SkinBlur{.direction = direction,
                                      .sigma_mm = glm::sqrt(glm::max(variance - done, 0.0f)),
                                      .smooth_mm = std::sqrt(std::min({done.x, done.y, done.z}))});
            pass.dispatch_threads(into.desc.size);
        };
        const Image* from = &passes.irradiance;
        glm::vec3 done(0.0f);
        for (size_t i = 0; i < passes.levels.size(); ++i) {
            const glm::vec3 variance = passes.sum[i].variance;
            if (i > 0) pass.wait();  // for the level before, and until nobody reads `between` any more
            line(*from, passes.between, {1, 0}, done, variance);
            pass.wait();
            line(passes.between, *passes.levels[i], {0, 1}, done, variance);
            from = passes.levels[i];
            done = variance;
        }
    });
}

}  // namespace lightwalk::solution
