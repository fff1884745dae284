// Exercise 12.blur_irradiance: a chain of blurs in one pass.
// As it stands the first Gaussian is blurred along u alone, and the others hold nothing.
#include "12_skin/exercises.h"

namespace lightwalk::exercise {

// [blur_irradiance]
// Records one compute pass, "skin blur", after which level i holds the irradiance blurred by the Gaussian sum[i]. Each
// is made from the level before it, the first from the irradiance: along u into `between`, then along v into the level.
// Two blurs in a row add their variances: what is left to do for sum[i] is the difference of its variance to that of
// the level it is made from, and `blur` takes a standard deviation in mm, for each channel; and in smooth_mm the
// standard deviation that what it reads has already, 0 for the irradiance: the least of the channels'. The pass says
// what it reads and writes; what stands in both lists is read and written. Dispatches of one pass run at the same time,
// or in any order: pass.wait() makes what follows see what was written before, and one more than needed costs time.
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
