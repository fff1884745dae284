// Temporal anti-aliasing against exact coverage, projected points, and the remains of vanished objects.
#include <fmt/core.h>

#include "taa_fixture.h"

using namespace lightwalk;

namespace {

const glm::uvec2 size{64, 64};

}  // namespace

TEST_CASE_METHOD(OnTaa, "shifts: evenly spread over the pixel, and none of them twice") {
    const auto shift = taa.accumulation().shift;
    glm::dvec2 mean(0);
    std::vector<int> cells(16, 0);
    for (int i = 0; i < 48; ++i) {
        const glm::vec2 s = shift(i);
        CHECK(glm::all(glm::lessThanEqual(glm::abs(s), glm::vec2(0.5f))));
        mean += glm::dvec2(s) / 48.0;
        ++cells[size_t(std::min(int((s.x + 0.5f) * 4), 3) * 4 + std::min(int((s.y + 0.5f) * 4), 3))];
        for (int k = 0; k < i; ++k) CHECK(shift(k) != s);
    }
    CHECK(glm::length(mean) < 0.03);
    for (const int count : cells) CHECK((count >= 1 && count <= 5));  // 3 on average
}

TEST_CASE_METHOD(OnTaa, "at rest the picture converges to the exact coverage, and is not shifted") {
    for (const double angle : {3.0, 20.0, 40.0, 77.0}) {
        const Line line{.angle_deg = angle, .point = {31.2, 31.7}};
        const auto world = [&](float x, float y, int) {
            return Sample{glm::vec3(glm::dot(glm::dvec2(x, y) - 0.5 - line.point, line.normal()) > 0 ? 1.0f : 0.0f),
                          0.5f};
        };
        INFO(angle << " degrees");
        taa.clipping.set("none");
        const double one = rest_error(draw_many(1, size, world), line),
                     all = rest_error(draw_many(32, size, world), line);
        taa.clipping.set("deviation");
        const double limited = rest_error(draw_many(32, size, world), line);
        fmt::print("at rest, {} degrees: error {:.3f} after 1 frame, {:.4f} after 32, {:.4f} with limits\n", angle, one,
                   all, limited);
        CHECK(one > 0.2);
        CHECK(all < 0.045);  // of 32 samples the last one is a thirty-second
        CHECK(limited < 0.05);
    }
}

// Wires a third of a pixel wide, and a grey wall: the truth is their share of each pixel.
TEST_CASE_METHOD(OnTaa, "where nothing changes the error falls with the frames, and nothing darkens", "[13.rest]") {
    struct Still : Drawing {
        using Drawing::Drawing;
        void draw(Frame&, const View&, Canvas&) override {}
    } still(owner, "still");
    drawings = {still};
    constexpr double spacing = 4.37, wide = 0.34, dark = 0.013, bright = 0.77;
    const auto wires_up_to = [&](double x) {  // length of wire from 0 to x
        return std::floor(x / spacing) * wide + std::min(x - spacing * std::floor(x / spacing), wide);
    };
    const auto world = [&](float x, float y, int) {
        if (y > 32) return Sample{glm::vec3(0.3137f), 0.5f};
        const double across = std::fmod(double(x) + 100 * spacing, spacing);
        return Sample{glm::vec3(float(across < wide ? bright : dark)), 0.5f};
    };
    const auto errors = [&](int frames) {  // RMS at the wires; the mean's error there and on the wall, as shares
        const ImageRgb found = draw_many(frames, size, world);
        double squares = 0, sum = 0, truth = 0, wall = 0;
        for (int y = 2; y < 30; ++y)
            for (int x = 2; x < 62; ++x) {
                const double share = wires_up_to(x + 1.0) - wires_up_to(x), right = dark + (bright - dark) * share;
                squares += std::pow(double(found.at(x, y).g) - right, 2) / (28 * 60);
                sum += double(found.at(x, y).g);
                truth += right;
            }
        for (int y = 36; y < 62; ++y)
            for (int x = 2; x < 62; ++x) wall += double(found.at(x, y).g) / (26 * 60);
        return glm::dvec3(std::sqrt(squares), sum / truth - 1, wall / 0.3137 - 1);
    };
    const glm::dvec3 few = errors(32), many = errors(256);
    fmt::print("at rest: RMS {:.4f} after 32 frames, {:.4f} after 256; means off by {:.2f}% and {:.2f}%\n", few.x,
               many.x, 100 * many.y, 100 * many.z);
    CHECK(many.x < 0.4 * few.x);
    CHECK(many.x < 0.008);
    CHECK(std::abs(many.y) < 0.01);
    CHECK(std::abs(many.z) < 0.001);
}

TEST_CASE_METHOD(OnTaa, "no ghost is left where something nearer has moved away", "[13.ghost]") {
    // A white square moves to the right by 6 pixels a frame, without motion vectors, in front of a dark wall.
    const auto world = [](float x, float y, int i) {
        const float left = 4.0f + 6.0f * float(i);
        const bool square = x > left && x < left + 16 && y > 20 && y < 44;
        return square ? Sample{glm::vec3(1.0f), 0.5f}
                      : Sample{glm::vec3(0.1f + 0.05f * float(int(x / 4 + y / 4) % 2)), 0.01f};
    };
    // Mean and largest light above the wall's where the square was four frames ago or earlier.
    const auto ghost = [&] {
        const ImageRgb found = draw_many(8, size, world);
        double most = 0, sum = 0;
        for (int y = 20; y < 44; ++y)
            for (int x = 4; x < 4 + 6 * 4; ++x) {
                const double above = std::max(double(found.at(x, y).g) - 0.15, 0.0);
                most = std::max(most, above);
                sum += above / (24 * 24);
            }
        return glm::dvec2(sum, most);
    };
    taa.clipping.set("none");
    const glm::dvec2 rejected = ghost();
    taa.reject.value = false;
    const glm::dvec2 kept = ghost();
    taa.clipping.set("deviation");
    const glm::dvec2 clipped = ghost();
    taa.reject.value = true;
    const glm::dvec2 both = ghost();
    fmt::print(
        "ghost four frames later, mean and largest: {:.4f} {:.3f} with all history, {:.4f} {:.3f} clipped, "
        "{:.4f} {:.3f} rejected, {:.4f} {:.3f} both\n",
        kept.x, kept.y, clipped.x, clipped.y, rejected.x, rejected.y, both.x, both.y);
    CHECK(kept.x > 0.1);
    CHECK(rejected.x < 0.5 * kept.x);  // its last column is left: there the wall was seen, too
    CHECK(both.x < 0.005);
    CHECK(both.y < 0.1);
}

TEST_CASE_METHOD(OnTaa, "the camera's motion: history follows points that are projected analytically") {
    // A wall at 2 m, seen by a camera that walks to the right: its pattern moves left by the focal length over 2 m.
    const double focal_px = 32 / std::tan(0.5 * double(camera.fov_y_rad));
    taa.clipping.set("none");
    owner.forget_history();
    ImageRgb found;
    const double step_m = 1.0 * 2.0 / focal_px;  // one pixel a frame: the history needs no filter
    const auto pattern = [](double x, double y) { return 0.5 + 0.4 * std::sin(x * 0.7) * std::cos(y * 0.5); };
    const float near_m = camera.near_m, far_m = camera.far_m,
                wall = (near_m * far_m / 2.0f - near_m) / (far_m - near_m);
    for (int i = 0; i < 12; ++i) {
        camera.position = {float(step_m * i), 0, 3};
        camera.target = {float(step_m * i), 0, 0};
        found = draw(size, [&](float x, float y) {
            return Sample{glm::vec3(float(pattern(double(x) + i, double(y)))), wall};
        });
    }
    double worst = 0;
    for (int y = 4; y < 60; ++y)
        for (int x = 4; x < 40; ++x)
            worst = std::max(worst, std::abs(double(found.at(x, y).g) - pattern(x + 0.5 + 11, y + 0.5)));
    fmt::print("camera that walks a pixel a frame: largest error {:.3f} of a pattern of 0.8\n", worst);
    CHECK(worst < 0.05);  // the mean over a pixel, and ten shifts that do not balance
}

TEST_CASE_METHOD(OnTaa, "repeated reads between pixels: Catmull-Rom keeps a pattern that bilinear reads lose",
                 "[figures][13.repeated_reads]") {
    const double focal_px = 32 / std::tan(0.5 * double(camera.fov_y_rad));
    const float near_m = camera.near_m, far_m = camera.far_m,
                wall = (near_m * far_m / 2.0f - near_m) / (far_m - near_m);
    const auto contrast = [&](const char* resample, double speed) {
        taa.resample.set(resample);
        taa.clipping.set("none");
        owner.forget_history();
        ImageRgb found;
        for (int i = 0; i < 32; ++i) {
            const float x = float(speed * i * 2.0 / focal_px);
            camera.position = {x, 0, 3};
            camera.target = {x, 0, 0};
            found = draw(size, [&](float px, float) {
                return Sample{glm::vec3(0.5f + 0.5f * float(std::sin(1.5708 * (double(px) + speed * i)))), wall};
            });
        }
        double sum = 0;  // RMS about the mean over that of the sine
        for (int y = 8; y < 56; ++y)
            for (int x = 8; x < 40; ++x) sum += std::pow(double(found.at(x, y).g) - 0.5, 2);
        return std::sqrt(sum / (48 * 32)) / (0.5 * std::sqrt(0.5));
    };
    for (const double speed : {0.0, 0.25, 0.5, 1.0})
        fmt::print("contrast of four pixels at {} px a frame: bilinear {:.2f}, Catmull-Rom {:.2f}\n", speed,
                   contrast("bilinear", speed), contrast("catmull_rom", speed));
    CHECK(contrast("bilinear", 0.5) < 0.5);
    CHECK(contrast("catmull_rom", 0.5) > contrast("bilinear", 0.5) + 0.15);
}
