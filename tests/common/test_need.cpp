// The need rule: crops stand for the whole picture, and the choice is the cheapest within the budget.
#include <random>

#include "catch.h"
#include "common/app/read_picture.h"
#include "common/app/target.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/files.h"
#include "common/check/check.h"
#include "common/study/crops.h"
#include "common/study/need.h"
#include "common/study/need_pictures.h"
#include "common/study/study.h"

using namespace lightwalk;
using nlohmann::json;

namespace {

ImageRgb noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    ImageRgb image(width, height);
    for (glm::vec3& pixel : image.pixels)
        for (int i = 0; i < 3; ++i) pixel[i] = float(random() % 1000) / 1000.0f;
    return image;
}

ImageRgb part(const ImageRgb& image, glm::uvec2 origin) {
    ImageRgb result(crop_px, crop_px);
    for (int y = 0; y < int(crop_px); ++y)
        for (int x = 0; x < int(crop_px); ++x) result.at(x, y) = image.at(int(origin.x) + x, int(origin.y) + y);
    return result;
}

struct PatchOfLight {
    glm::ivec2 low, high;
    float light;
};

const Pipeline fill = compute({.shader = "patch of light", .macros = {}, .source = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;
layout(scalar) uniform PatchBlock { ivec2 low, high; float light; } patch_of_light;
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool within = all(greaterThanEqual(pixel, patch_of_light.low)) && all(lessThan(pixel, patch_of_light.high));
    if (all(lessThan(pixel, imageSize(result)))) imageStore(result, pixel, vec4(vec3(within ? patch_of_light.light : 0.0), 1));
}
)"});

// A black picture with a patch of light in one corner of it; `coarse` is too bright there by `excess`.
struct Patch : Chapter {
    Choice method{*this, "method", {"exact", "coarse", "dear"}, "exact", "how"};
    Knob<float> excess{*this, "excess", 0.2f, {0.0f, 4.0f}, "how wrong the coarse method is"};
    Knob<int> detail{*this, "detail", 1, {1, 64}, "divides the excess"};
    glm::uvec2 lower{500, 300}, upper{600, 340};  // of a picture of 640 x 360
    bool codes = false;                           // the encoded picture is judged
    std::vector<glm::uvec2> sizes;

    Patch() { name = "99_patch"; }
    std::string default_scene() const override { return ""; }
    Model load_model(const std::filesystem::path&) override { return {}; }
    ImageView written(const Frame& frame) const override { return codes ? Chapter::written(frame) : frame.linear(); }
    void frame(Frame& frame) override {
        sizes.push_back(frame.size);
        const float light = 0.3f + (method.is("coarse") ? excess / float(detail.value) : 0.0f);
        const float scale = float(frame.crop.whole.x) / 640.0f;
        const glm::ivec2 low = glm::clamp(glm::ivec2(glm::vec2(lower) * scale) - glm::ivec2(frame.crop.origin),
                                          glm::ivec2(0), glm::ivec2(frame.size));
        const glm::ivec2 high = glm::clamp(glm::ivec2(glm::vec2(upper) * scale) - glm::ivec2(frame.crop.origin),
                                           glm::ivec2(0), glm::ivec2(frame.size));
        frame.compute("fill", {.writes = {frame.hdr}}, [&](Compute& pass) {
            pass.use(fill).set("result", frame.hdr).set("patch_of_light", PatchOfLight{low, high, light});
            pass.dispatch_threads(frame.size);
        });
        encode_srgb(frame);
    }
};

struct NeedTest {
    Patch chapter;
    StudyPlan plan;
    NeedQuestion question{.budgets = {0.01}, .picture = {.size = {640, 360}}, .crops = true};
    // The choice must not depend on the machine's load.
    double cost_ms() const { return chapter.method.is("exact") ? 24 : chapter.method.is("dear") ? 12 : 1; }
    NeedTest() {
        question.clock = [this](const Frame&) { return cost_ms(); };
        plan.truth = {{"method", "exact"}};
        plan.candidates = {
            {"exact", {}, {}}, {"dear", {}, {}}, {"coarse", {{"detail", "1"}}, {}}, {"coarse", {{"detail", "64"}}, {}}};
    }
    json choose(double budget) {
        question.budgets = {budget};
        return choose_candidates(chapter, check_device(), plan, question)[0];
    }
    // Of the coarse method, with and without crops.
    double error(const json& said, size_t i = 2) { return said["candidates"][i]["error"].get<double>(); }
};

}  // namespace

TEST_CASE("need: crops cover a picture once, and FLIP of a crop is that of the whole picture") {
    const glm::uvec2 whole(200, 149);
    const ImageRgb a = noise(200, 149, 1), b = noise(200, 149, 2);
    const ErrorMap map = flip_ldr(a, b);
    std::vector<int> covered(200 * 149);
    double mean = 0;
    for (const CropPlace& place : cut(whole)) {
        for (unsigned y = place.lower.y; y < place.upper.y; ++y)
            for (unsigned x = place.lower.x; x < place.upper.x; ++x) ++covered[y * 200 + x];
        CHECK(glm::all(glm::lessThanEqual(place.origin + crop_px, whole)));
        const double error = mean_of_crop(flip_ldr(part(a, place.origin), part(b, place.origin)), place);
        CHECK(error == Approx(mean_over(map, whole, place)).epsilon(1e-5));
        mean += place.share * error;
    }
    CHECK(std::all_of(covered.begin(), covered.end(), [](int times) { return times == 1; }));
    CHECK(mean == Approx(summarize(map).mean).epsilon(1e-5));
}

TEST_CASE("need: an estimate has the picture's mean as its expected value, and knows its own error") {
    std::vector<double> errors(300), chances(300), shares(300, 1.0 / 300);
    std::mt19937 random(7);
    double mean = 0, all = 0;
    for (size_t i = 0; i < 300; ++i) {
        errors[i] = i % 10 == 0 ? 0.5 : 0.01 * double(random() % 10);
        chances[i] = 1.0 + double(random() % 8) + 10.0 * errors[i];
        mean += errors[i] / 300;
        all += chances[i];
    }
    for (double& chance : chances) chance /= all;
    double sum = 0;
    int within = 0;
    constexpr int runs = 400;
    for (int run = 0; run < runs; ++run) {
        Estimate estimate;
        for (const size_t i : draw_places(chances, 32, (run + 0.5) / runs))
            estimate.add(errors[i], shares[i], chances[i]);
        REQUIRE(estimate.count() == 32);
        sum += estimate.mean();
        within += std::fabs(estimate.mean() - mean) <= 3 * estimate.standard_error();
    }
    CHECK(sum / runs == Approx(mean).epsilon(0.01));
    CHECK(within >= int(0.97 * runs));
    Estimate one;
    one.add(0.5, 0.1, 0.1);
    CHECK(std::isinf(one.standard_error()));
}

TEST_CASE_METHOD(NeedTest, "need: the cheapest within the budget is taken, on crops as on whole pictures") {
    question.crops = false;
    question.picture.size = {320, 180};
    json whole = choose(0.005);
    CHECK(whole["crops"] == 0);
    CHECK(whole["choice"]["knobs"] == json{{"detail", 64}});
    CHECK(chapter.method.is("coarse"));
    CHECK(chapter.detail == 64);
    CHECK_FALSE(whole["none_would_do"]);
    const double exact_error = error(whole);
    CHECK(exact_error > 0.005);
    CHECK(choose(1.1 * exact_error)["choice"]["time_ms"] == 1);
    CHECK(choose(0)["choice"]["time_ms"] == 12);
    CHECK((choose(0)["choice"]["method"] == "dear" && chapter.method.is("dear")));

    // The patch is a 58th of the picture: crops find it because the small picture shows it.
    question.crops = true;
    question.picture.size = {640, 360};
    chapter.sizes.clear();
    const json crops = choose(0.002);
    CHECK(crops["crops"].get<int>() >= 16);
    CHECK(crops["choice"]["knobs"] == json{{"detail", 64}});
    CHECK(crops["candidates"][2]["enough"] == false);
    CHECK(std::count(chapter.sizes.begin(), chapter.sizes.end(), glm::uvec2(crop_px)) > 32);
    question.crops = false;
    question.picture.size = {640, 360};
    CHECK(error(crops) == Approx(error(choose(0))).epsilon(0.4));
}

TEST_CASE("need: crops are drawn where they pay for all candidates, not for the truth alone") {
    // Bloom over the workbench at 940 x 720, as measured: each crop draws the scene's vertices and shadows again.
    CHECK_FALSE(crops_are_cheaper(16, {82, 3270}, {141, 1957}, 8));
    CHECK(crops_are_cheaper(16, {8, 3000}, {2, 30}, 8));  // a truth that is slow
    CHECK_FALSE(crops_are_cheaper(64, {8, 3000}, {20, 30}, 8));
}

TEST_CASE_METHOD(NeedTest, "need: where none would do the most accurate one is taken, and it is said") {
    question.picture.size = {320, 180};
    plan.candidates.erase(plan.candidates.begin(), plan.candidates.begin() + 2);
    const json said = choose(1e-6);
    CHECK(said["none_would_do"]);
    CHECK(said["choice"]["knobs"] == json{{"detail", 64}});
    CHECK(said["choice"]["enough"] == false);
    CHECK(said["candidates"].size() == 2);
}

TEST_CASE_METHOD(NeedTest, "need: what is set on the command line and a candidate's `where` leave candidates out") {
    question.picture.size = {64, 36};
    plan.candidates[1].where = {{"excess", "0.5"}};
    CHECK(choose(1)["candidates"].size() == 3);
    chapter.excess.value = 0.5f;
    CHECK(choose(1)["candidates"].size() == 4);
    chapter.detail.value = 1;
    chapter.detail.pinned = true;
    CHECK(choose(1)["candidates"].size() == 3);
    CHECK(chapter.detail == 1);
    chapter.detail.value = 5;
    plan.candidates.erase(plan.candidates.begin(), plan.candidates.begin() + 2);
    CHECK_THROWS_WITH(choose(1), Catch::Matchers::Contains("no candidate of chapter 99_patch agrees"));
}

TEST_CASE_METHOD(NeedTest,
                 "need: the error is that of the pictures that would be written: rounded, and white at most") {
    question.picture.size = {320, 180};
    for (const float excess : {0.2f, 0.011f, 0.001f, 3.0f}) {
        chapter.excess.value = excess;
        const auto written = [&](const char* method) {
            const std::string before = chapter.method.text();
            chapter.method.set(method);
            chapter.detail.value = 1;
            Frame frame(check_device());
            render(chapter, frame, question.picture);
            chapter.method.set(before);
            return to_linear(read_picture(check_device(), frame.output));
        };
        chapter.codes = true;
        const double found = error(choose(0)), right = summarize(flip_ldr(written("exact"), written("coarse"))).mean;
        chapter.codes = false;
        INFO("excess " << excess << ": " << found << ", written " << right << ", in linear light " << error(choose(0)));
        CHECK(found == Approx(right).margin(1e-7));
        if (excess == 0.001f) CHECK(error(choose(0)) > found + 1e-5);  // no code, or a whole one
        if (excess == 3.0f) CHECK(right == Approx(error(choose(0))).epsilon(0.5));
    }
}

TEST_CASE_METHOD(NeedTest, "need: the time is the GPU's of all passes, where no clock is given") {
    const FrameClock clock = NeedQuestion{}.clock;
    Frame frame(check_device());
    frame.times = {{.name = "a", .gpu_ms = 1}, {.name = "b", .gpu_ms = 2}, {.name = "c", .gpu_ms = 4}};
    CHECK(clock(frame) == 7);
}

TEST_CASE("need: auto in a chapter without a study is refused before there is a device") {
    Patch chapter;
    Options options;
    CHECK_FALSE(automatic_choice(options, chapter).after);
    options.automatic = true;
    options.budget = 0.1;
    CHECK_THROWS_WITH(automatic_choice(options, chapter), Catch::Matchers::Contains("99_patch has no study"));
}
