// The tour's steps, and the part of a window that an output of another shape fills.
#include <cmath>

#include "18_playground/editor_part.h"
#include "18_playground/playground.h"
#include "catch.h"

using namespace lightwalk;

TEST_CASE("each step of the tour ends with what it asks for, and with nothing else", "[18.tour]") {
    Tour::Facts begin{.camera = glm::vec3(1), .done = 3, .objects = 2, .lights = 1};
    const auto after = [&](auto change) {
        Tour::Facts now = begin;
        change(now);
        return now;
    };
    // By step: looking around, selecting, a step of the document, undo, another tool, a light, a model, sky, weather, saving.
    const Tour::Facts done[] = {
        after([](auto& now) { now.camera.x = 2; }),       after([](auto& now) { now.selected = 1; }),
        after([](auto& now) { now.done = 4; }),           after([](auto& now) { now.done = 2; }),
        after([](auto& now) { now.tool = Tool::scale; }), after([](auto& now) { now.lights = 2; }),
        after([](auto& now) { now.objects = 3; }),        after([](auto& now) { now.sky = true; }),
        after([](auto& now) { now.weather = true; }),     after([](auto& now) { now.saved = true; })};
    for (size_t step = 1; step <= std::size(done); ++step) {
        CAPTURE(step);
        CHECK_FALSE(Tour::is_done(step, begin, begin));
        for (size_t i = 0; i < std::size(done); ++i) CHECK(Tour::is_done(step, begin, done[i]) == (i + 1 == step));
    }
    CHECK_FALSE(Tour::is_done(6, begin, after([](auto& now) { now.lights = 0; })));  // a light that went
    CHECK_FALSE(Tour::is_done(7, begin, after([](auto& now) { now.objects = 1; })));
}

// What is inside of the frame is what the output shows: as high as the camera's own angle.
TEST_CASE("the frame of an output has its shape, lies in the middle and shows the camera's whole angle",
          "[18.output]") {
    const double shapes[] = {0, 4.0 / 3, 16.0 / 9, 2.39, 1};
    Camera camera;
    camera.fov_y_rad = 0.7f;
    OutputFrame output;
    for (const glm::uvec2 window : {glm::uvec2(460, 700), {1600, 900}, {1200, 400}, {3840, 2160}})
        for (output.shape = 0; output.shape < std::size(shapes); ++output.shape) {
            CAPTURE(window.x, window.y, output.shape);
            const Area inside = output.area(window);
            const glm::uvec2 end = inside.corner + inside.size;
            CHECK(glm::all(glm::lessThanEqual(end, window)));
            CHECK((inside.size.x == window.x || inside.size.y == window.y));
            for (int i = 0; i < 2; ++i) CHECK(std::abs(int(inside.corner[i]) - int(window[i] - end[i])) <= 1);
            const double shape = output.shape ? shapes[output.shape] : double(window.x) / window.y;
            CHECK(std::abs(inside.size.x - shape * inside.size.y) <= 0.5 * (1 + shape));
            const double seen = std::tan(0.5 * output.seen(camera, window).fov_y_rad) * inside.size.y / window.y;
            CHECK(std::abs(seen / std::tan(0.35) - 1) < 0.5 / inside.size.y + 1e-6);
        }
}
