// Where levels go wrong: a bound where the methods hold, the size of the failure where they do not.
#include "04_surface_maps/levels.h"
#include "04_surface_maps/maps.h"
#include "chain_fixture.h"
#include "common/base/files.h"
#include "common/image/image.h"

using namespace lightwalk;

namespace {

constexpr VkFormat half4 = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr VkFormat srgb8 = VK_FORMAT_R8G8B8A8_SRGB;

double sinc(double x) { return std::fabs(x) < 1e-9 ? 1 : std::sin(M_PI * x) / (M_PI * x); }

// Reads of a map by footprints that are given in texels: what a surface's shader does with its derivatives.
struct OnFootprints : OnChain {
    static constexpr uint32_t places = 256;
    Maps maps{owner, "maps"};
    const Buffer seen{gpu.device, {.name = "seen", .bytes = 4 * places}};
    const Pipeline look = compute_pipeline("footprints", R"(
#include "04_surface_maps/read_map.glsl"
layout(local_size_x = 64) in;
uniform sampler2D map;
layout(scalar) uniform FootprintBlock { vec2 across, down; } footprint;
layout(scalar) buffer SeenBuffer { float seen[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    vec2 at = vec2(i % 16u, i / 16u) / 16.0, size = vec2(textureSize(map, 0));
    seen[i] = read(map, Coordinates(at, footprint.across / size, footprint.down / size)).r;
}
)");

    struct Grating {
        const char* name;
        glm::dvec2 waves, across, down;  // waves over the map's width and height; a pixel's footprint in texels
    };

    // RMS errors of the options in order. The truth is the integral of a cosine over a parallelogram, divided by its area.
    std::vector<double> errors_of(const Grating& g) {
        const glm::uvec2 size{509, 331};
        const auto cosine = [&](glm::dvec2 at) { return std::cos(2 * M_PI * glm::dot(g.waves, at)); };
        // v grows upwards, and rows of texels downwards.
        const Image map = image(size, one_float, [&](uint32_t, uint32_t x, uint32_t y) {
            return glm::dvec4(0.5 + 0.5 * cosine(glm::dvec2(x + 0.5, size.y - y - 0.5) / glm::dvec2(size)));
        });
        fill(map, "polyphase");
        const glm::dvec2 per_texel = g.waves / glm::dvec2(size);
        const double contrast = sinc(glm::dot(per_texel, g.across)) * sinc(glm::dot(per_texel, g.down));
        std::vector<double> errors;
        std::string text = fmt::format("{}: errors", g.name);
        for (const std::string& limit : maps.anisotropy.options) {
            const std::vector<float> found = read_with(limit, map, g.across, g.down);
            double sum = 0;
            for (uint32_t i = 0; i < places; ++i) {
                const double truth = 0.5 + 0.5 * contrast * cosine({(i % 16) / 16.0, (i / 16) / 16.0});
                sum += std::pow(double(found[i]) - truth, 2);
            }
            errors.push_back(std::sqrt(sum / places));
            text += fmt::format(" {:.4f}", errors.back());
        }
        UNSCOPED_INFO(text);
        return errors;
    }

    std::vector<float> read_with(const std::string& limit, const Image& map, glm::vec2 across, glm::vec2 down) {
        maps.anisotropy.set(limit);
        const std::array<glm::vec2, 2> footprint{across, down};
        begin({4, 4});
        frame.compute("footprints", {.reads = {map}, .writes = {seen}}, [&](Compute& pass) {
            pass.use(look, maps.macros()).set("map", map).set("footprint", footprint).set("seen", seen);
            pass.dispatch({places / 64, 1, 1});
        });
        frame.end();
        return read<float>(seen);
    }
};

}  // namespace

TEST_CASE_METHOD(OnChain, "every size has all its levels, and their means are those of a reference on the host") {
    for (const glm::uvec2 size : odd_sizes) {
        const Image noisy = image(size, one_float, noise);
        for (const std::string method : {"box", "single_pass"}) {
            fill(noisy, method);
            truth::Texels above = level(noisy, 0);
            for (uint32_t m = 1; m < noisy.desc.mips; ++m) {
                const truth::Texels found = level(noisy, m);
                double worst = 0;
                for (uint32_t y = 0; y < found.size.y; ++y)
                    for (uint32_t x = 0; x < found.size.x; ++x) {
                        const auto at = [&](uint32_t i, uint32_t j) {
                            return above
                                .at(std::min(2 * x + i, above.size.x - 1), std::min(2 * y + j, above.size.y - 1))
                                .r;
                        };
                        const double mean = 0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1));
                        worst = std::max(worst, std::fabs(found.at(x, y).r - mean));
                    }
                INFO(method << " " << size.x << "x" << size.y << " level " << m);
                CHECK(worst < 1e-6);
                above = found;
            }
        }
    }
}

TEST_CASE_METHOD(OnChain, "sizes that fit no tile and no power of two: every method fills every level of them") {
    // Halves that are rounded towards 0 at every level lose a little at each.
    for (const glm::uvec2 size : {glm::uvec2{1023, 5}, {3, 1366}, {1080, 2}, {4096, 3}, {2, 4097}, {16384, 1}}) {
        const Image flat = image(size, half4, [](auto...) { return glm::dvec4(0.25, 0.5, 4.0, 1); });
        for (const std::string& method : filters) {
            fill(flat, method);
            for (uint32_t m = 1; m < flat.desc.mips; ++m)
                for (const glm::dvec4& texel : level(flat, m).values) {
                    INFO(method << " " << size.x << "x" << size.y << " level " << m);
                    REQUIRE(glm::length(texel - glm::dvec4(0.25, 0.5, 4.0, 1)) < 0.03);
                }
        }
    }
}

TEST_CASE_METHOD(OnChain, "beyond 64x64 tiles a single pass takes several, and is right", "[07.large]") {
    const Image wide = image({8192, 3}, one_float, [](uint32_t, uint32_t x, uint32_t) { return glm::dvec4(x); });
    fill(wide, "single_pass");
    CHECK(last(wide).r == Approx(4095.5).epsilon(1e-5));
    for (const double error : errors(wide)) CHECK(error < 0.01);
}

TEST_CASE_METHOD(OnChain, "a checker of black and white is 188 and not 128", "[07.checker]") {
    const auto checker = [](uint32_t, uint32_t x, uint32_t y) { return glm::dvec4(glm::dvec3((x + y) % 2), 1); };
    const Image codes = image({64, 64}, srgb8, checker);
    for (const std::string& method : filters) {
        fill(codes, method);
        INFO(method);
        CHECK(std::round(255 * level(codes, 1).at(9, 9).r) == Approx(188).margin(method == "blit" ? 1 : 0));
        CHECK(std::round(255 * last(codes).g) == Approx(188).margin(1));
        CHECK(last(codes).a == 1);
    }
    fill(codes, "box", Content::linear);  // codes averaged as if they were light; devices round halves as they like
    CHECK(255 * level(codes, 1).at(9, 9).r == Approx(127.5).margin(0.51));
}

TEST_CASE_METHOD(OnChain, "a ramp's mean survives odd sizes with polyphase alone", "[07.ramp]") {
    const auto ramp_of = [&](uint32_t width) {
        return image({width, 1}, one_float,
                     [=](uint32_t, uint32_t x, uint32_t) { return glm::dvec4((x + 0.5) / width); });
    };
    struct Expected {
        uint32_t width;
        double floor_2x2;
    };
    for (const Expected e : {Expected{1023, 0.25}, {255, 0.25}, {7, 0.25}, {3, 0.25}, {1366, 0.375}, {1080, 0.474}}) {
        const Image ramp = ramp_of(e.width);
        for (const std::string method : {"box", "single_pass"}) {
            fill(ramp, method);
            INFO(method << " " << e.width);
            // The share of the ramp that is left: its first texels. Of width 3: the mean of two of three.
            const uint32_t kept = 1u << (ramp.desc.mips - 1);
            CHECK(last(ramp).r == Approx(0.5 * kept / e.width).epsilon(1e-4));
        }
        fill(ramp, "polyphase");
        CHECK(last(ramp).r == Approx(0.5).epsilon(1e-5));
        fill(ramp, "blit");
        WARN("ramp of " << e.width << ": box ends at " << 0.5 * (1u << (ramp.desc.mips - 1)) / e.width
                        << ", this driver's blit at " << last(ramp).r << ", truth 0.5");
    }
}

TEST_CASE_METHOD(OnChain, "polyphase is exact for one step of an odd size, and nearly so for several") {
    const Image noisy = image({683, 341}, one_float, noise);
    std::map<std::string, std::vector<double>> of;
    for (const std::string& method : filters) {
        fill(noisy, method);
        of[method] = errors(noisy);
    }
    CHECK(of["polyphase"][0] < 1e-6);
    CHECK(of["box"][0] > 0.05);
    for (size_t m = 0; m < of["box"].size(); ++m) CHECK(of["polyphase"][m] <= 0.75 * of["box"][m] + 1e-6);
    // Powers of two need nothing of the kind.
    const Image even = image({256, 256}, one_float, noise);
    for (const std::string method : {"box", "single_pass", "polyphase"}) {
        fill(even, method);
        for (const double error : errors(even)) CHECK(error < 1e-6);
    }
    fill(even, "kaiser");  // another filter: it does not aim at the mean over a texel's area
    CHECK(errors(even)[0] > 0.01);
}

TEST_CASE_METHOD(OnChain,
                 "codes are rounded at every level by a dispatch a level, and twice at most by a single pass") {
    const Image codes = image({512, 512}, srgb8, noise);
    std::map<std::string, double> worst;
    for (const std::string method : {"box", "single_pass"}) {
        fill(codes, method, Content::srgb);
        for (const double error : errors(codes, Content::srgb)) worst[method] = std::max(worst[method], error);
    }
    WARN("worst level of 512x512 sRGB noise: box " << worst["box"] << ", single pass " << worst["single_pass"]);
    CHECK(worst["single_pass"] <= worst["box"]);
    CHECK(worst["single_pass"] < 0.004);
}

TEST_CASE_METHOD(OnChain, "a counter that holds any number, as a broken run leaves it, does no harm",
                 "[07.any_counter]") {
    // No run resets its counter: each of these starts with the previous one's.
    for (const glm::uvec2 size : {glm::uvec2{256, 192}, {130, 257}, {256, 192}, {512, 64}, {256, 256}}) {
        const Image noisy = image(size, one_float, noise, 2);
        fill(noisy, "box");
        const double right = last(ImageView(noisy).layer(1)).r;
        const Image again = image(size, one_float, noise, 2);
        fill(again, "single_pass");
        CHECK(last(ImageView(again).layer(1)).r == Approx(right).epsilon(1e-5));
    }
}

TEST_CASE_METHOD(OnChain, "opposite normals cancel: a direction all the same, and alpha says that nothing is left") {
    const auto across = [](uint32_t, uint32_t x, uint32_t) { return glm::dvec4(x % 2 ? 1 : 0, 0.5, 0.5, 0); };
    const Image opposed = image({8, 8}, half4, across);
    for (const std::string method : {"box", "single_pass", "polyphase", "kaiser"}) {
        fill(opposed, method, Content::normal);
        for (uint32_t m = 1; m < opposed.desc.mips; ++m) {
            const glm::dvec4 texel = level(opposed, m).values[0];
            INFO(method << " level " << m);
            CHECK(glm::length(glm::dvec3(texel) - glm::dvec3(0.5, 0.5, 1)) < (method == "kaiser" ? 1.2 : 1e-3));
            CHECK(texel.a == Approx(1).margin(method == "kaiser" ? 0.2 : 1e-3));
        }
    }
    // Chapter 04's result for the same map on the host.
    const Image slopes = image({64, 64}, VK_FORMAT_R8G8B8A8_UNORM, [](uint32_t, uint32_t x, uint32_t y) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(std::sin(0.4 * x), std::cos(0.9 * y), 1.5));
        return glm::dvec4(0.5 + 0.5 * n, 0);
    });
    Level codes{{64, 64}, {}};
    for (const glm::dvec4& texel : level(slopes, 0).values) codes.texels.emplace_back(texel);
    const std::vector<Level> expected = normal_levels(codes);
    fill(slopes, "single_pass", Content::normal);
    for (uint32_t m = 1; m < slopes.desc.mips; ++m) {
        const truth::Texels found = level(slopes, m);
        for (size_t i = 0; i < found.values.size(); ++i)
            CHECK(glm::length(found.values[i] - glm::dvec4(expected[m].texels[i])) < 0.02);
    }
}

TEST_CASE_METHOD(OnChain, "NaN and infinity in one texel stay in the texels that cover it", "[07.not_finite]") {
    for (const double bad : {double(NAN), double(INFINITY)}) {
        const glm::uvec2 size{65, 48};
        const glm::uvec2 where{40, 21};
        const Image image_with = image(size, one_float, [&](uint32_t, uint32_t x, uint32_t y) {
            return glm::dvec4(glm::uvec2(x, y) == where ? bad : 1.0);
        });
        for (const std::string& method : filters) {
            fill(image_with, method);
            for (uint32_t m = 1; m < image_with.desc.mips; ++m) {
                const truth::Texels found = level(image_with, m);
                size_t outside = 0;
                for (uint32_t y = 0; y < found.size.y; ++y)
                    for (uint32_t x = 0; x < found.size.x; ++x) {
                        // Two more texels for the wide filter, plus each level's own; one for a device's blits.
                        const double reach = method == "kaiser"                           ? 4.5
                                             : method == "box" || method == "single_pass" ? 0
                                                                                          : 1;
                        const glm::dvec2 scale = glm::dvec2(size) / glm::dvec2(found.size);
                        const glm::dvec2 off =
                            glm::abs((glm::dvec2(x, y) + 0.5) * scale - glm::dvec2(where) - 0.5) / scale;
                        const bool may = off.x <= 1.0 + reach && off.y <= 1.0 + reach;
                        outside += !may && !std::isfinite(found.at(x, y).r);
                    }
                INFO(method << " level " << m);
                CHECK(outside == 0);
            }
        }
    }
}

TEST_CASE_METHOD(OnChain, "every format, arrays, cubes, single faces") {
    for (const VkFormat format :
         {srgb8, VK_FORMAT_R8G8B8A8_UNORM, half4, VK_FORMAT_R16G16_UNORM, VK_FORMAT_R16G16_SFLOAT, one_float}) {
        const Image cube = image({32, 32}, format, noise, 6, true);
        const Image array = image({40, 20}, format, noise, 3);
        for (const std::string method : {"blit", "single_pass", "polyphase"}) {
            INFO(name_of(format) << " " << method);
            fill(cube, method);
            fill(array, method);
            for (uint32_t layer = 0; layer < 3; ++layer) {
                const double face = 255 * last(ImageView(cube).face(layer)).r;
                double mean = 0;
                for (const glm::dvec4& texel : read_texels(gpu, ImageView(cube).face(layer)).values)
                    mean += (format == srgb8 ? truth::srgb_to_linear(texel.r) : texel.r) / 1024;
                // A device may round each blit as it likes: this one rounds codes up.
                CHECK(face == Approx(255 * (format == srgb8 ? truth::linear_to_srgb(mean) : mean))
                                  .margin(method == "blit" ? 4 : 1));
                CHECK(std::isfinite(last(ImageView(array).layer(layer)).r));
            }
        }
        // One face alone: the others stay as they are.
        const double before = last(ImageView(cube).face(2)).r;
        fill(ImageView(cube).face(1), "single_pass", Content::linear);
        CHECK(last(ImageView(cube).face(2)).r == before);
    }
}

TEST_CASE_METHOD(OnChain, "coverage is kept down the levels") {
    const TexelImage grass = read_texels(course_root() / "assets/textures/grass_cutout.png", false);
    const auto texel_of = [&](uint32_t, uint32_t x, uint32_t y) {
        glm::dvec4 texel;
        for (int c = 0; c < 4; ++c)
            texel[c] = std::to_integer<int>(grass.bytes[4 * (size_t(y) * grass.width + x) + size_t(c)]) / 255.0;
        return texel;
    };
    const Image blades = image({grass.width, grass.height}, srgb8, texel_of);
    const double wanted = covered(blades, 0, 0.5);
    for (const std::string method : {"box", "single_pass", "polyphase", "kaiser"}) {
        fill(blades, method, Content::cutout, 0.5f);
        for (uint32_t m = 1; m < 7; ++m) {
            INFO(method << " level " << m);
            const double texels = static_cast<double>(level(blades, m).values.size());
            CHECK(covered(blades, m, 0.5) == Approx(wanted).margin(0.03 + 1 / texels));
        }
    }
    const Image halves = image({grass.width, grass.height}, half4, texel_of);
    fill(halves, "box", Content::cutout, 0.5f);
    CHECK(covered(halves, 5, 0.5) == Approx(wanted).margin(0.03));
    const Image without_alpha = image({grass.width, grass.height}, one_float, texel_of);
    CHECK_NOTHROW(fill(without_alpha, "box", Content::cutout, 0.5f));
    fill(blades, "box", Content::srgb);  // alpha averaged and left at that
    CHECK(covered(blades, 8, 0.5) == 0);
    WARN("grass: covers " << wanted << "; at 16x16 texels " << covered(blades, 5, 0.5)
                          << " where alpha is only averaged");
}

TEST_CASE_METHOD(OnChain, "roughness: the mean of two is rougher than their mean", "[07.mean_roughness]") {
    const Image orm =
        image({4, 4}, half4, [](uint32_t, uint32_t x, uint32_t) { return glm::dvec4(1, x % 2 ? 1 : 0, 0.5, 1); });
    fill(orm, "single_pass", Content::roughness);
    CHECK(last(orm).g == Approx(std::pow(0.5, 0.25)).margin(1e-3));  // 0.84, not 0.5
    CHECK(last(orm).b == Approx(0.5).margin(1e-3));
}

TEST_CASE_METHOD(OnFootprints, "anisotropy: each doubling of the reads comes nearer to the mean over the footprint",
                 "[07.anisotropy]") {
    const glm::dvec2 upright(0, 24), lying(24, 0);
    for (const Grating& g : {Grating{"lines along the footprint", {40, 0}, {1.5, 0}, upright},
                             Grating{"lines along a footprint that lies", {0, 27}, lying, {0, 1.5}},
                             Grating{"fine lines along the footprint", {80, 0}, {0, 30}, {1, 0}},
                             Grating{"lines along an oblique footprint", {25, -25 * 331.0 / 509}, {20, 20}, {-1, 1}},
                             Grating{"lines across the footprint", {0, 9}, {1.5, 0}, upright},
                             Grating{"lines at an angle to the footprint", {30, 4}, {1.5, 0}, upright}}) {
        const std::vector<double> errors = errors_of(g);
        for (size_t i = 1; i < errors.size(); ++i) CHECK(errors[i] < errors[i - 1]);
        CHECK(errors.back() < 0.4 * errors.front());
    }
}

TEST_CASE_METHOD(OnFootprints, "anisotropy gains nothing where a rolled camera makes both derivatives equally long",
                 "[07.rolled]") {
    const glm::dvec2 upright(0, 24), across(1.5, 0);
    const std::vector<double> level = errors_of({"", {40, 0}, across, upright});
    // The same footprint from diagonal steps: its sides are now the halves of a rhombus' diagonals.
    const std::vector<double> rolled =
        errors_of({"", {40, 0}, std::sqrt(0.5) * (upright + across), std::sqrt(0.5) * (upright - across)});
    CHECK(level.back() < 0.2 * level.front());
    CHECK(rolled.back() > 0.9 * rolled.front());
}
