// Temporal anti-aliasing while something changes: the size of the picture, the method, the scene, the camera, its knobs.
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "taa_fixture.h"

using namespace lightwalk;

namespace {

const auto squares = [](float x, float y) { return Sample{glm::vec3(float(int(x / 5 + y / 3) % 2)), 0.5f}; };

double farthest(const ImageRgb& a, const ImageRgb& b) {
    REQUIRE(a.pixels.size() == b.pixels.size());
    double most = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) most = std::max(most, std::fabs(double(a.pixels[i][c]) - double(b.pixels[i][c])));
    return most;
}

struct OnLiveTaa : OnTaa {
    static constexpr glm::uvec2 usual{33, 21};

    void gather(int frames) {
        owner.forget_history();
        drawn = 0;
        for (int i = 0; i < frames; ++i) draw(usual, squares);
    }
    /// The frame of this number without any before it.
    ImageRgb cold(int number, glm::uvec2 pixels = usual) {
        owner.forget_history();
        drawn = number;
        return draw(pixels, squares);
    }
    /// The fifth frame, after four others and a change. All that it shows is new.
    void check_cold_after(const std::function<void()>& change) {
        gather(4);
        change();
        drawn = 4;
        const ImageRgb after = draw(usual, squares);
        CHECK(farthest(after, cold(4)) == 0);
        gather(4);
        CHECK(farthest(draw(usual, squares), after) > 0.1);  // with a history it differs
    }
};

}  // namespace

TEST_CASE_METHOD(OnLiveTaa, "another size is a cold start, also an odd one and back again", "[13.taa_live]") {
    for (const glm::uvec2 pixels : {glm::uvec2(34, 21), {7, 5}, {1, 1}, {1, 40}, {65, 2}}) {
        INFO(pixels.x << "x" << pixels.y);
        gather(4);
        const ImageRgb changed = draw(pixels, squares), next = draw(pixels, squares), back = draw(usual, squares);
        CHECK(farthest(changed, cold(4, pixels)) == 0);
        CHECK(farthest(next, draw(pixels, squares)) == 0);
        CHECK(farthest(back, cold(6)) == 0);
    }
}

TEST_CASE_METHOD(OnLiveTaa, "after a frame without it, or by another method, there is no history", "[13.taa_live]") {
    check_cold_after([&] {
        begin(usual);
        frame.end();
    });
    for (const char* other : {"none", "mlaa", "fxaa_like", "smaa_like"}) {
        INFO(other);
        check_cold_after([&] {
            by.method.set(other);
            draw(usual, squares);
            by.method.set("taa");
        });
    }
}

TEST_CASE_METHOD(OnLiveTaa, "another scene is a cold start, also one that is loaded where the former one was",
                 "[13.taa_live]") {
    Scene first, second;
    first.file.file = second.file.file = "first.json";
    scene = &first;
    check_cold_after([&] { scene = &second; });
    check_cold_after([&] { scene->file.file = "second.json"; });
    check_cold_after([&] { scene = nullptr; });
}

TEST_CASE_METHOD(OnLiveTaa, "after a cut to what the camera did not see there is no history", "[13.taa_live]") {
    const Camera before = camera;
    const glm::vec3 ahead = camera.target - camera.position;
    for (const glm::vec3 aside : {glm::vec3(1e4f, 0, 0), glm::vec3(0, -1e4f, 0)}) {
        check_cold_after([&] { camera.position += aside, camera.target += aside; });
        camera = before;
    }
    check_cold_after([&] { camera.target = camera.position - ahead; });
}

TEST_CASE_METHOD(OnLiveTaa, "knobs set anew in every frame leave no trace once they are back", "[13.taa_live]") {
    taa.at_rest.set("4");
    const auto settle = [&] {
        ImageRgb last;
        for (drawn = 100; drawn < 150;) last = draw(usual, squares);
        return last;
    };
    gather(40);
    const ImageRgb never = settle();
    gather(3);
    std::mt19937 random(13);
    const char* const clipping[] = {"none", "box", "deviation"};
    for (int i = 0; i < 40; ++i) {
        taa.clipping.set(clipping[random() % 3]);
        taa.resample.set(random() % 2 ? "bilinear" : "catmull_rom");
        taa.weights.set(random() % 2 ? "even" : "tone");
        taa.reject.set(random() % 2 ? "on" : "off");
        taa.gamma.set(random() % 2 ? "0" : "8");
        const ImageRgb now = draw(usual, squares);
        double lowest = 1, highest = 0;
        for (const glm::vec3& p : now.pixels) {
            lowest = std::min<double>(lowest, p.r);
            highest = std::max<double>(highest, p.r);
        }
        CHECK(lowest >= 0);
        CHECK(highest <= 1);
    }
    for (KnobBase* knob : {static_cast<KnobBase*>(&taa.clipping), static_cast<KnobBase*>(&taa.resample),
                           static_cast<KnobBase*>(&taa.weights), static_cast<KnobBase*>(&taa.reject),
                           static_cast<KnobBase*>(&taa.gamma)})
        knob->reset();
    CHECK(farthest(settle(), never) < 2e-3);
}
