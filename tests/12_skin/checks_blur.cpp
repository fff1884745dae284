// What ./course check runs for 12.blur_irradiance: chains on a validated device, whose lines add up what they were
// told.
#include <fmt/core.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "12_skin/exercises.h"
#include "common/check/check.h"
#include "common/check/guard.h"

using namespace lightwalk;

namespace {

// Adds half of the variance it is told to red, green and blue, so that both directions together add all of it; and to
// alpha 1 for u, 32 for v, 1024 where smooth_mm is not what the texels say of themselves.
const char* const line_source = R"(
#include "12_skin/profile.h"
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D from, stretch;
layout(rgba16f) writeonly uniform image2D into;
layout(scalar) uniform SkinBlurBlock { SkinBlur blur; };
void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(into)))) return;
    vec4 own = texelFetch(from, texel, 0);
    vec3 variance = blur.sigma_mm * blur.sigma_mm, before = own.rgb - 0.5 * float(blur.direction.y) * variance;
    float smooth_before = sqrt(max(min(before.x, min(before.y, before.z)), 0.0));
    own.a += float(blur.direction.x) + 32.0 * float(blur.direction.y);
    if (abs(blur.smooth_mm - smooth_before) > 0.02 + 0.02 * smooth_before) own.a += 1024.0;
    if (texelFetch(stretch, texel, 0).x != 0.25) own.a += 4096.0;
    imageStore(into, texel, vec4(own.rgb + 0.5 * variance, own.a));
}
)";

glm::vec4 texel_of(Gpu& gpu, const Image& image, size_t at) {
    const auto texels = gpu.read_back(image);
    uint64_t texel = 0;
    std::memcpy(&texel, &texels[8 * at], 8);
    return glm::unpackHalf4x16(texel);
}

void fill(Frame& frame, const Image& image, glm::vec4 value) {
    const std::vector<uint64_t> texels(size_t(image.desc.size.x) * image.desc.size.y, glm::packHalf4x16(value));
    frame.upload(image.desc.name, image, std::as_bytes(std::span(texels)));
}

// What is wrong with a level; empty for nothing.
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
    std::string said;
    {
        Gpu gpu({.name = "",
                 .validate = true,
                 .surface_extensions = {},
                 .max_push_descriptors = {},
                 .on_message = [&](const char* message) {
                     if (said.empty()) said = message;
                 }});
        const Pipeline line = compute({.shader = "the line of the check", .source = line_source});
        Frame frame(gpu);
        for (const int count : {6, 1, 3}) {
            const std::vector<Gaussian> sum = gaussians_of(count);
            const glm::uvec2 size(20, 12);
            const auto image = [&](const char* name) { return Image(gpu.device, {.name = name, .size = size}); };
            const Image irradiance = image("irradiance"), stretch = image("stretch"), between = image("between");
            std::vector<Image> levels;
            for (size_t i = 0; i < sum.size(); ++i) levels.push_back(image("level"));
            std::vector<const Image*> pointers;
            for (const Image& level : levels) pointers.push_back(&level);
            frame.begin({4, 4}, 0.0f);
            fill(frame, irradiance, glm::vec4(0)), fill(frame, stretch, glm::vec4(0.25f));
            fill(frame, between, glm::vec4(0, 0, 0, -9));
            for (const Image& level : levels) fill(frame, level, glm::vec4(0, 0, 0, -9));
            const std::string what = fmt::format("a sum of {}: ", count);
            guard_call("blur_irradiance");
            try {
                blur_irradiance(frame, {line, irradiance, stretch, between, pointers, sum});
            } catch (const std::exception& e) {
                guard_call("");
                frame.end();
                check.expect(false, what + e.what(), "what a pass binds stands in its reads or writes");
                return;
            }
            guard_call("");
            frame.end();
            size_t passes = 0;
            for (const PassTime& pass : frame.times) passes += pass.name == "skin blur" && pass.stage == "compute";
            check.expect(passes == 1,
                         what + fmt::format("there are {} compute passes \"skin blur\", expected one", passes));
            // The first and the last texel: nothing is left out at the sides.
            for (const size_t at : {size_t(0), size_t(size.x) * size.y - 1})
                for (size_t i = 0; i < levels.size(); ++i) {
                    const std::string found = wrong(texel_of(gpu, levels[i], at), sum[i], i);
                    check.expect(found.empty(), what + found);
                }
            check.expect(texel_of(gpu, irradiance, 0) == glm::vec4(0),
                         what + "the irradiance was written, and is to be read alone");
        }
    }
    check.expect(said.empty(), "validation says: " + said,
                 "pass.wait() before what reads or overwrites what the dispatch before used");
}
