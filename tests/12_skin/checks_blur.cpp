// Checks of 12.blur_irradiance: chains of several lengths, and the contents of their levels.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "12_skin/sums.h"
#include "blur_stage.h"
#include "common/check/check.h"
#include "trials.h"

using namespace lightwalk;

namespace {

struct SkinChain {
    std::string error;              // the exception; then nothing else is known
    int passes = 0;                 // compute passes called "skin blur"
    std::vector<glm::vec4> levels;  // two texels of each, the first and the last
    glm::vec4 irradiance{0.0f};     // its first texel
    std::string validation;         // its first message
};

SkinChain seen_of(int count, const RecordedFrame& recorded) {
    SkinChain seen;
    BlurStage stage(count);
    stage.begin();
    seen.error = replay(stage.frame, recorded, stage.cast);
    stage.frame.end();
    if (!seen.error.empty()) return seen;
    for (const PassTime& pass : stage.frame.times) seen.passes += pass.name == "skin blur" && pass.stage == "compute";
    for (const Image& level : stage.levels)
        for (const size_t at : {size_t(0), size_t(stage.size.x) * stage.size.y - 1})
            seen.levels.push_back(stage.texel_of(level, at));
    seen.irradiance = stage.texel_of(stage.irradiance, 0);
    seen.validation = stage.validation;
    return seen;
}

// The fault of a level; empty if none.
std::string wrong(glm::vec4 got, const Gaussian& wanted, size_t i) {
    const std::string which = fmt::format("level {} ", i);
    if (!(got.a == got.a) || got.a < 0) return which + "was never written: it holds what was there before";
    if (got.a >= 4096) return which + "was made with another texture than the stretch";
    if (got.a >= 1024)
        return which +
               "was made with a smooth_mm that is not the standard deviation of the level it reads (0 for the "
               "irradiance)";
    const int u = int(got.a) % 32, v = int(got.a) / 32;
    if (u != int(i) + 1 || v != int(i) + 1)
        return fmt::format("{}has been blurred {} times along u and {} along v, expected {} of each", which, u, v,
                           i + 1);
    for (int c = 0; c < 3; ++c)
        if (std::fabs(got[c] - wanted.variance[c]) > 0.004f * wanted.variance[c] + 1e-5f)
            return fmt::format(
                "{}has a variance of {:.4g} mm², expected {:.4g}: variances add up, standard deviations do "
                "not",
                which, got[c], wanted.variance[c]);
    return "";
}

}  // namespace

CHECK_EXERCISE("12.blur_irradiance",
               "two dispatches for each level with a wait between them and before the next; sigma is the root of the "
               "difference of the variances") {
    for (const int count : {6, 1, 3}) {
        const std::vector<Gaussian> sum = gaussians_of(count);
        const SkinChain seen = seen_of(count, try_blur_irradiance(count));
        const std::string what = fmt::format("a sum of {}: ", count);
        if (!seen.error.empty()) {
            check.expect(false, what + seen.error, hint_for(seen.error));
            return;
        }
        check.expect(seen.passes == 1,
                     what + fmt::format("there are {} compute passes \"skin blur\", expected one", seen.passes));
        check.expect(seen.levels.size() == 2 * sum.size(), what + "not all levels were seen");
        // The first and the last texel: nothing is left out at the sides.
        for (size_t i = 0; i < std::min(seen.levels.size(), 2 * sum.size()); ++i) {
            const std::string found = wrong(seen.levels[i], sum[i / 2], i / 2);
            check.expect(found.empty(), what + found);
        }
        check.expect(seen.irradiance == glm::vec4(0), what + "the irradiance was written, and is to be read alone");
        check.expect(seen.validation.empty(), what + "validation says: " + seen.validation,
                     "pass.wait() before what reads or overwrites what the dispatch before used");
    }
}
