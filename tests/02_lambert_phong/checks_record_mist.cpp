// Checks of 02.record_mist: two frames, with the colours of each.
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "common/check/check.h"
#include "mist_stage.h"
#include "trials.h"

using namespace lightwalk;

namespace {

std::string color_text(glm::vec3 c) {
    return "(" + number_text(double(c.x)) + ", " + number_text(double(c.y)) + ", " + number_text(double(c.z)) + ")";
}

// Meaning of a wrong colour.
std::string words_for(glm::vec3 got, bool scene) {
    if (got.x > 100 || !(got.x == got.x)) return "hdr holds what a pass has discarded: what is drawn over must be kept";
    if (got.y > 0.9f && !(scene && got.x > 0))
        return scene ? "the depth is that of the frame before, the nearest there is, and hides the scene: clear it to 0"
                     : "the depth is that of the frame before where nothing was drawn: clear it to 0";
    if (got.x > 0 && !scene) return "the scene of the frame before still shows";
    if (got.z == 0 && !scene) return "the sky is not there: no pass has drawn it, or the pass after it has cleared it";
    if (scene && got.y == 0) return "the mist is not there, or came before the scene";
    return "that is none of what the passes make";
}

struct MistFrame {
    std::string error;                  // the exception; then nothing else is known
    std::string passes;                 // "sky (compute), shade (raster), ..."
    glm::vec3 left{0.0f}, right{0.0f};  // linear light, of a pixel in either half
};

MistFrame seen_of(MistStage& stage, const RecordedFrame& recorded) {
    MistFrame seen;
    seen.error = replay(stage.frame, recorded, stage.cast);
    stage.frame.end();
    if (!seen.error.empty()) return seen;
    for (const PassTime& pass : stage.frame.times)
        if (&pass != &stage.frame.times[0])
            seen.passes += (seen.passes.empty() ? "" : ", ") + pass.name + " (" + pass.stage + ")";
    const auto texels = stage.gpu.read_back(stage.frame.hdr);
    const auto at = [&](size_t x) {
        uint64_t texel = 0;
        std::memcpy(&texel, &texels[8 * (8 * 16 + x)], 8);
        return glm::vec3(glm::unpackHalf4x16(texel));
    };
    seen.left = at(3);
    seen.right = at(12);
    return seen;
}

}  // namespace

CHECK_EXERCISE("02.record_mist",
               "in each pass, keep an image whose content is still needed; clear it, or overwrite all of it, if it "
               "belongs to the previous frame") {
    // A half float holds them exactly.
    const float red = 1.0f - 0.0625f * float(check_seed() % 8), blue = 1.0f - 0.0625f * float(check_seed() / 8 % 8);
    const std::vector<RecordedFrame> recorded = try_record_mist(red, blue);
    check.expect(recorded.size() == 2, "record_mist was called " + std::to_string(recorded.size()) + " times");
    MistStage stage(red, blue);
    for (size_t i = 0; i < recorded.size() && i < 2; ++i) {
        const bool right = i == 1;
        stage.begin(right);
        const MistFrame frame = seen_of(stage, recorded[i]);
        if (!frame.error.empty()) {
            check.expect(false, frame.error, hint_for(frame.error));
            return;
        }
        const std::string what = right ? "the second frame, in which the scene is on the right: "
                                       : "a frame in which the scene is on the left: ";
        check.expect(frame.passes == "sky (compute), shade (raster), mist (compute)",
                     what + "the passes are " + (frame.passes.empty() ? "none" : frame.passes) +
                         ", expected sky (compute), shade (raster), mist (compute)");
        check.expect(stage.draws == 1,
                     what + "the scene is drawn " + std::to_string(stage.draws) + " times, expected once");
        for (const bool right_half : {false, true}) {
            const glm::vec3 got = right_half ? frame.right : frame.left;
            const bool scene = right == right_half;
            const glm::vec3 wanted = scene ? glm::vec3(red, 0.5f, 0) : glm::vec3(0, 0, blue);
            check.expect(got == wanted, what + "where " + (scene ? "the scene" : "the sky alone") +
                                            " is to be seen is " + color_text(got) + ", expected " +
                                            color_text(wanted) + " (red the scene, blue the sky, green the depth " +
                                            "that the mist found): " + words_for(got, scene));
        }
    }
    check.expect(stage.validation.empty(), "validation says: " + stage.validation,
                 "let the passes' statements make the barriers");
}
