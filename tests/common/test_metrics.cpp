// Errors and statistics, with the numbers worked out by hand, and the choice among measured methods.
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "catch.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/statistics.h"
#include "common/measure/metrics.h"
#include "common/study/cheapest.h"

using namespace lightwalk;
using nlohmann::json;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("RMSE, relative RMSE and maximum by hand") {
    ImageRgb reference(2, 1), test(2, 1);
    reference.pixels = {{0, 0, 0}, {1, 0.5f, 1}};
    test.pixels = {{0.3f, 0, 0}, {1, 0.9f, 1}};
    const Difference d = difference(reference, test);
    CHECK(d.pixels == 2);
    CHECK(d.mse == Approx((0.09 + 0.16) / 6));
    CHECK(d.rmse == Approx(std::sqrt((0.09 + 0.16) / 6)));
    CHECK(d.relative_rmse == Approx(std::sqrt((0.09 / 0.01 + 0.16 / 0.26) / 6)));
    CHECK(d.max == Approx(0.4));
    const Difference back = difference(test, reference);
    CHECK(back.rmse == Approx(d.rmse));
    CHECK(back.relative_rmse != Approx(d.relative_rmse));  // relative to the reference
    CHECK(difference(reference, reference).rmse == 0.0);
    CHECK_THROWS_AS(difference(reference, ImageRgb(1, 2)), InputError);
}

TEST_CASE("NaN and Inf are counted and left out of every mean") {
    ImageRgb reference(4, 1, glm::vec3(0.5f)), test = reference;
    test.pixels[0] = {float(nan_value), float(infinite), 0};  // NaN wins: counted once
    test.pixels[1] = {0, 0, -float(infinite)};
    reference.pixels[2].y = float(nan_value);
    test.pixels[3].x = 0.75f;
    const Difference d = difference(reference, test);
    CHECK((d.test.nan == 1 && d.test.inf == 1));
    CHECK((d.reference.nan == 1 && d.reference.inf == 0));
    CHECK(d.pixels == 1);
    CHECK(d.rmse == Approx(0.25 / std::sqrt(3.0)));
    CHECK(d.max == Approx(0.25));
    CHECK(count_non_finite(test).total() == 2);
    const Difference none = difference(ImageRgb(2, 2, glm::vec3(float(nan_value))), ImageRgb(2, 2));
    CHECK(none.pixels == 0);
    CHECK(std::isnan(none.rmse));  // nothing was compared, so nothing is claimed
}

TEST_CASE("PSNR has the mean square, not its root, under the logarithm") {
    CHECK(psnr_db(1e-4) == Approx(40.0));
    CHECK(psnr_db(0.01) == Approx(20.0));
    CHECK(psnr_db(4.0, 2.0) == Approx(0.0).margin(1e-12));
    CHECK(psnr_db(0.0) == infinite);
    CHECK(std::isnan(psnr_db(nan_value)));
}

TEST_CASE("The largest step names a pixel that has it") {
    Image8 a(5, 4, {10, 20, 30, 255}), b = a;
    CHECK(max_step_difference(a, b).steps == 0);
    b.at(1, 1).g = 23;
    b.at(3, 2).b = 0;
    b.at(4, 3).a = 250;
    const StepDifference d = max_step_difference(a, b);
    CHECK((d.steps == 30 && d.x == 3 && d.y == 2 && d.pixels == 3));
    CHECK(max_step_difference(b, a).steps == 30);
    CHECK_THROWS_AS(max_step_difference(a, Image8(4, 5)), InputError);
}

TEST_CASE("One step away is one step in every channel, white included") {
    const Image8 image(2, 2, {0, 254, 255, 77}), moved = one_step_away(image);
    CHECK(moved.at(1, 1) == glm::u8vec4(1, 255, 254, 77));
    CHECK(max_step_difference(image, moved).steps == 1);
}

TEST_CASE("An image on which nothing was drawn is nearly constant, a small object is not") {
    CHECK(is_nearly_constant(Image8()));
    Image8 image(100, 100, {40, 50, 60, 255});
    CHECK(is_nearly_constant(image));
    for (int i = 0; i < 19; ++i) image.at(i, 3) = {255, 255, 255, 255};  // 0.19% of it
    CHECK(is_nearly_constant(image));
    image.at(60, 60) = {255, 255, 255, 255};  // 0.2%
    CHECK_FALSE(is_nearly_constant(image));
    Image8 dithered(100, 100);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) dithered.at(x, y) = glm::u8vec4(100 + 4 * ((x + y) % 2), 100, 100, 255);
    CHECK(is_nearly_constant(dithered));
    Image8 ramp(256, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 256; ++x) ramp.at(x, y).b = uint8_t(x);  // one channel is enough
    CHECK_FALSE(is_nearly_constant(ramp));
}

TEST_CASE("Percentiles, median and quartiles; NaN has no rank") {
    const std::vector<double> values = {5, nan_value, 1, 3, 2, 4};
    CHECK(median(values) == 3.0);
    CHECK(percentile(values, 0.0) == 1.0);
    CHECK(percentile(values, 1.0) == 5.0);
    CHECK(percentile(values, 0.99) == Approx(4.96));
    const Quartiles q = quartiles(std::vector<float>{1, 2, 3, 4});
    CHECK((q.q1 == 1.75 && q.median == 2.5 && q.q3 == 3.25));
    CHECK(median(std::vector<double>{7}) == 7.0);
    CHECK(std::isnan(median(std::vector<double>{})));
    CHECK(std::isnan(median(std::vector<double>{nan_value})));
    CHECK(median(std::vector<double>{1, infinite, infinite}) == infinite);
    CHECK(percentile(std::vector<double>{infinite, infinite}, 0.3) == infinite);
}

TEST_CASE("The need rule chooses as a study's verdict does") {
    for (const json& known : json::parse(read_file(course_root() / "tests/common/data/cheapest.json"))) {
        CAPTURE(known["name"]);
        std::vector<Measured> all;
        for (const json& point : known["points"])
            all.push_back({point[0], point[1], double(point[0]) <= double(known["limit"])});
        CHECK(cheapest(all) == size_t(known["choice"]));
    }
    CHECK(cheapest({{nan_value, 1, false}, {0.5, 2, false}}) == 1);
}
