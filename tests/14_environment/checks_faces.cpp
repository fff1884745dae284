// Checks of 14.prefilter_faces: its dispatches' results in every face of every level.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "common/check/check.h"
#include "faces_stage.h"
#include "trials.h"

using namespace lightwalk;

namespace {

struct FacesSeen {
    std::string error;              // the exception; then nothing else is known
    std::string passes;             // compute passes: "first, second"
    std::vector<glm::vec4> texels;  // level by level, face by face, row by row
    std::string validation;         // its first message
};

FacesSeen seen_of(uint32_t texels, uint32_t levels, const std::vector<RecordedFrame>& recorded) {
    FacesSeen seen;
    FacesStage stage(texels, levels);
    std::tie(seen.error, seen.passes) = replay_twice(stage, recorded);
    if (!seen.error.empty()) return seen;
    for (uint32_t m = 0; m < levels; ++m) {
        const auto bytes = stage.gpu.read_back(stage.prefiltered.as_array().mip(m));
        const size_t before = seen.texels.size();
        seen.texels.resize(before + bytes.size() / sizeof(glm::vec4));
        std::memcpy(seen.texels.data() + before, bytes.data(), bytes.size());
    }
    seen.validation = stage.validation;
    return seen;
}

bool reads_nearest(const std::vector<RecordedFrame>& recorded) {
    for (const RecordedFrame& frame : recorded)
        for (const RecordedPass& pass : frame.passes)
            for (const RecordedStep& step : pass.steps)
                if (step.kind == RecordedStep::Kind::set_views && step.binding == "radiance" &&
                    step.sampler.filter != Filter::linear)
                    return true;
    return false;
}

}  // namespace

CHECK_EXERCISE("14.prefilter_faces",
               "two loops, over levels and faces: set face_level and face_now, then dispatch; all in one pass") {
    struct Size {
        uint32_t texels, levels;
    };
    for (const Size size : {Size{16, 5}, Size{24, 3}, Size{8, 1}}) {
        const std::vector<RecordedFrame> recorded = try_prefilter_faces(size.texels, size.levels);
        const FacesSeen seen = seen_of(size.texels, size.levels, recorded);
        const std::string what = fmt::format("a cube of {} texels and {} levels: ", size.texels, size.levels);
        if (!seen.error.empty()) {
            const bool given = seen.error.find("given") != seen.error.npos;
            check.expect(
                false, what + seen.error,
                given ? "what else the filter reads comes with the pass: .with = passes.with" : hint_for(seen.error));
            return;
        }
        check.expect(seen.passes == "prefilter",
                     what + fmt::format("the compute passes are \"{}\", expected one, \"prefilter\"", seen.passes));
        std::string wrong, hint;
        size_t next = 0;
        for (uint32_t m = 0; m < size.levels && wrong.empty(); ++m) {
            const uint32_t side = std::max(size.texels >> m, 1u), across = (side + 7) / 8;
            const float roughness = size.levels > 1 ? float(m) / float(size.levels - 1) : 0.0f;
            for (uint32_t face = 0; face < 6 && wrong.empty(); ++face)
                for (uint32_t i = 0; i < side * side && wrong.empty(); ++i, ++next) {
                    const glm::vec4 got = next < seen.texels.size() ? seen.texels[next] : glm::vec4(-9);
                    const std::string place =
                        fmt::format("{}the texel ({}, {}) of face {} of level {} ", what, i % side, i / side, face, m);
                    if (got.x == -9) {
                        wrong = place + "was never written";
                        hint = m == 0 && face == 0
                                   ? "a thread for each texel of the view: dispatch_threads(level.size())"
                               : m == 0 || face == 0 ? "a dispatch for each of six faces of each level, up to "
                                                       "desc.mips - 1, into a view of both"
                                                     : "";
                    } else if (got.x != float(face + 1)) {
                        wrong = place + fmt::format("was written for face {}", got.x - 1);
                        hint = "face_now.face is the face of which face_level is a view";
                    } else if (!(std::fabs(got.y - roughness) < 1e-5f)) {
                        wrong = place + fmt::format("has roughness {}, expected {}", got.y, roughness);
                        hint = "even steps: level / (levels - 1), and 0 for a cube of one level";
                    } else if (got.w != 2) {
                        wrong = place + fmt::format("is from radiance {}, expected 2: passes.radiance", got.w);
                        hint = "\"radiance\" is passes.radiance as it is in this frame, read by the pass";
                    } else if (got.z != float(across * across)) {
                        wrong = place + fmt::format(
                                            "was written by {} groups of 8x8 threads, expected {}: a thread for "
                                            "each texel of the view",
                                            got.z, across * across);
                        hint = "each level's view has a size of its own: dispatch_threads(level.size())";
                    }
                }
        }
        check.expect(wrong.empty(), wrong, hint);
        check.expect(!wrong.empty() || !reads_nearest(recorded), what + "\"radiance\" is read by its nearest texel",
                     "set(\"radiance\", passes.radiance, linear_clamp)");
        check.expect(seen.validation.empty(), what + "validation says: " + seen.validation);
        if (!wrong.empty()) return;
    }
}
