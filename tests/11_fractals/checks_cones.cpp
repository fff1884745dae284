// Checks of 11.record_cones: both dispatches' results in their images.
#include <fmt/core.h>

#include <algorithm>

#include "common/check/check.h"
#include "cones_stage.h"
#include "trials.h"

using namespace lightwalk;

namespace {

struct ConesSeen {
    std::string error;              // the exception; then nothing else is known
    std::string passes;             // compute passes: "first, second"
    std::vector<glm::vec4> starts;  // texel by texel, from the second of two frames
    std::vector<glm::vec4> found;
    std::string validation;  // its first message
};

ConesSeen seen_of(glm::ivec2 size, const std::vector<RecordedFrame>& recorded) {
    ConesSeen seen;
    ConesStage stage(size);
    std::tie(seen.error, seen.passes) = replay_twice(stage, recorded);
    if (!seen.error.empty()) return seen;
    seen.starts = stage.texels_of(stage.starts);
    seen.found = stage.texels_of(stage.found);
    seen.validation = stage.validation;
    return seen;
}

}  // namespace

CHECK_EXERCISE("11.record_cones",
               "passes.cone, wait(), passes.march; the first dispatch writes `starts`, the second reads it.") {
    Random random;
    const glm::ivec2 drawn(random.uniform(9, 90), random.uniform(9, 90));
    for (const glm::ivec2 size : {glm::ivec2(40, 24), glm::ivec2(61, 43), drawn}) {
        const ConesSeen seen = seen_of(size, try_record_cones(size));
        const std::string what = fmt::format("{}x{} pixels: ", size.x, size.y);
        if (!seen.error.empty()) {
            check.expect(false, what + seen.error, hint_for(seen.error));
            return;
        }
        check.expect(seen.passes == "julia march",
                     what + fmt::format("the compute passes are \"{}\", expected one, \"julia march\"", seen.passes));
        const glm::ivec2 tiles = (size + 7) / 8;
        const auto groups = [](glm::ivec2 threads) { return float(((threads.x + 7) / 8) * ((threads.y + 7) / 8)); };
        // The first wrong texel, by its kind of fault.
        const auto look = [&](const std::vector<glm::vec4>& texels, glm::ivec2 extent, int per_tile,
                              const char* dispatch, const char* image) {
            std::string wrong;
            for (int i = 0; i < int(texels.size()) && wrong.empty(); ++i) {
                const glm::ivec2 at(i % extent.x, i / extent.x), tile = at / per_tile;
                const glm::vec4 got = texels[size_t(i)];
                const std::string place = fmt::format("the texel ({}, {}) of `{}` ", at.x, at.y, image);
                if (got.w == -9)
                    wrong = place + "was never written";
                else if (got.x == -9)
                    wrong = place + "is from a start that no cone had written";
                else if (got != glm::vec4(2, tile.x, tile.y, got.w))
                    wrong = fmt::format("{}has the start ({}, {}, {}), expected (2, {}, {})", place, got.x, got.y,
                                        got.z, tile.x, tile.y);
                else if (got.w != groups(extent))
                    wrong = fmt::format(
                        "passes.{} ran in {} groups of 8x8 threads, expected {}: a thread for each texel "
                        "of `{}`",
                        dispatch, got.w, groups(extent), image);
            }
            check.expect(int(texels.size()) == extent.x * extent.y && wrong.empty(), what + wrong);
        };
        look(seen.starts, tiles, 1, "cone", "starts");
        look(seen.found, size, 8, "march", "found");
        check.expect(seen.validation.empty(), what + "validation says: " + seen.validation,
                     "pass.wait() before what reads what the dispatch before has written");
    }
}
