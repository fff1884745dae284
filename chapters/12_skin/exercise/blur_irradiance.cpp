// Exercise 12.blur_irradiance: a chain of blurs in one pass.
// Starter: the first Gaussian is blurred along u only, and the other levels stay empty.
#include "12_skin/exercises.h"

namespace lightwalk::exercise {

// [blur_irradiance]
// Records one compute pass called "skin blur". Afterwards passes.levels[i] holds the
// irradiance blurred by the Gaussian passes.sum[i]; the narrowest comes first.
//
// Each level takes two dispatches of passes.line. The first blurs its source along u,
// direction (1, 0), into passes.between. The second blurs `between` along v, direction
// (0, 1), into the level. The source of level 0 is passes.irradiance, that of every
// other level is the level before it.
//
// Besides the direction, the shader's block `blur` (a SkinBlur) takes:
// - sigma_mm: the standard deviation of this blur, for each channel. Blurs that follow
//   each other add their variances, so this blur has to supply only the difference
//   between the variance of sum[i] and that of its source. The irradiance has the
//   variance 0.
// - smooth_mm: the standard deviation that the source of the level already has, in the
//   channel where it is smallest; 0 for the irradiance. It is the same in both dispatches.
//
// The pass declares all images that it reads and all that it writes; an image of which
// both is true appears in both lists. Dispatches of one pass may run at the same time
// or in any order. pass.wait() makes the results of the earlier ones visible, and also
// lets them finish reading. Each unnecessary wait costs time.
// [/blur_irradiance]
void blur_irradiance(Frame& frame, const BlurPasses& passes) {
    const Image& first = *passes.levels.front();
    frame.compute("skin blur", {.reads = {passes.irradiance, passes.stretch}, .writes = {first}}, [&](Compute& pass) {
        pass.use(passes.line).set("from", passes.irradiance, nearest_clamp).set("into", first);
        pass.set("stretch", passes.stretch, nearest_clamp);
        const glm::vec3 sigma_mm = glm::sqrt(passes.sum.front().variance);
        pass.set("blur", SkinBlur{.direction = {1, 0}, .sigma_mm = sigma_mm, .smooth_mm = 0.0f});
        pass.dispatch_threads(first.desc.size);
    });
}

}  // namespace lightwalk::exercise
