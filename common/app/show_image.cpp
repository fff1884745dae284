#include "common/app/show_image.h"

#include "common/image_shown.h"

namespace lightwalk {
namespace {

const Pipeline always = compute({.shader = "common/show_image.comp"});
const Pipeline gated = compute({.shader = "common/show_image.comp", .macros = {{"GATED", "1"}}});

}  // namespace

void show_image(Frame& frame, const Image& image, const ImageView& over, const ShowImage& how) {
    const glm::vec2 picture(over.size());
    ImageShown shown{.first = glm::vec2(how.texels),
                     .extent = {how.texels.z, how.texels.w},
                     .place = glm::vec2(0.0f),
                     .size = picture,
                     .gain = how.gain,
                     .around = 0.0f,
                     .gate = static_cast<int>(how.gate)};
    if (shown.extent == glm::vec2(0.0f)) shown.extent = glm::vec2(image.desc.size);
    if (how.aspect > 0.0f) {
        const float width = std::min(picture.x, how.aspect * picture.y);
        shown.size = {width, width / how.aspect};
        shown.place = 0.5f * picture - 0.5f * shown.size;
        shown.around = 0.01f;
    }
    ComputeAccess access{.reads = {image}, .writes = {over}};
    if (how.words) access.reads.push_back(*how.words);
    frame.compute(how.pass, access, [&](Compute& pass) {
        pass.use(how.words ? gated : always).set("image", image, nearest_clamp).set("shown", shown);
        if (how.words) pass.set("words", *how.words);
        pass.set("result", over).dispatch_threads(over.size());
    });
}

}  // namespace lightwalk
