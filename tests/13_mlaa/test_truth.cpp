// The truth: 64 samples against the exact coverage of a half-plane, and four samples where they are said to lie.
#include "01_obj/camera_view.h"
#include "13_mlaa/edge_error.h"
#include "13_mlaa/four_samples.h"
#include "13_mlaa/outlines.h"
#include "mlaa_fixture.h"

using namespace lightwalk;

namespace {

struct OnHalfPlane : OnModules {
    HalfPlane half_plane{owner, "half_plane"};
    FourSamples four{owner};
    const glm::uvec2 size{48, 32};

    ImageRgb drawn(glm::vec2 shift, bool four_times = false) {
        begin(size);
        const auto draw_from = [&](const View& view) {
            Canvas canvas(frame.hdr, frame.depth);
            lightwalk::draw(frame, view, canvas, {half_plane});
        };
        const View view = view_of(Camera(), size, {.whole = size, .shift = shift});
        if (four_times)
            four.supersample(frame, view, draw_from);
        else
            draw_from(view);
        frame.end();
        return read_linear(gpu, frame.hdr);
    }
    Line line() const {
        return {
            .angle_deg = double(half_plane.angle_deg.value),
            .point = 0.5 * glm::dvec2(size) - 0.5 +
                     double(half_plane.offset.value) * Line{.angle_deg = double(half_plane.angle_deg.value)}.normal()};
    }
};

}  // namespace

TEST_CASE_METHOD(OnHalfPlane, "the half-plane's 64 samples come as near to its exact coverage as 64 samples can") {
    for (const float angle : {3.0f, 27.0f, 45.5f, 100.0f, 213.0f}) {
        half_plane.angle_deg.value = angle;
        half_plane.offset.value = 1.3f;
        std::vector<double> mean(48 * 32, 0.0);
        for (int i = 0; i < 64; ++i) {
            const ImageRgb one = drawn({(float(i % 8) + 0.5f) / 8 - 0.5f, (float(i / 8) + 0.5f) / 8 - 0.5f});
            for (size_t p = 0; p < mean.size(); ++p) mean[p] += double(one.pixels[p].g) / 64;
        }
        double worst = 0;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 48; ++x)
                worst = std::max(worst, std::abs(mean[size_t(y * 48 + x)] - line().exact(x, y)));
        INFO(angle << " degrees");
        CHECK(worst < 0.075);  // a row of eight samples on one side of the line, or the other: 1/16, and half a sample
    }
}

TEST_CASE_METHOD(OnHalfPlane, "four samples lie in four rows and four columns, and each counts a quarter") {
    half_plane.angle_deg.value = 33;
    const ImageRgb found = drawn({0, 0}, true);
    const glm::dvec2 places[] = {{-0.125, -0.375}, {0.375, -0.125}, {-0.375, 0.125}, {0.125, 0.375}};
    size_t wrong = 0, between = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) {
            double expected = 0;
            for (const glm::dvec2& place : places)
                expected += 0.25 * (glm::dot(glm::dvec2(x, y) - place - line().point, line().normal()) > 0);
            double other_way = 0;
            for (const glm::dvec2& place : places)
                other_way += 0.25 * (glm::dot(glm::dvec2(x, y) + place - line().point, line().normal()) > 0);
            const double got = double(found.at(x, y).g);
            wrong += got != expected && got != other_way;
            between += got > 0 && got < 1;
        }
    CHECK(wrong == 0);
    CHECK(between > 40);
    CHECK(edge_error(found, line()) < 0.6 * edge_error(drawn({0, 0}), line()));
}

TEST_CASE("the error of edge pixels: where samples differ from one, and the largest step everywhere else") {
    ImageRgb one(2, 2), truth(2, 2), found(2, 2);
    truth.pixels[1] = glm::vec3(0.5f);
    found.pixels[1] = glm::vec3(0.25f, 0.5f, 0.5f);
    found.pixels[2] = glm::vec3(0, 1, 0);
    const EdgePixels result = compare_edges(found, one, truth);
    CHECK(result.share == 0.25);
    CHECK(result.rmse == Approx(0.25 / std::sqrt(3.0)));
    CHECK(result.off_edges == Approx(255));
    CHECK(compare_edges(one, one, one).rmse == 0);
}
