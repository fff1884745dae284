// How a march reads the transfer function: at its edges, by its table, and as closed forms say.
#include "16_volume/volume.h"
#include "16_volume/volume_data.h"
#include "volume_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(OnVolume, "a density behind the last empty entry of the function is marched through",
                 "[16.transfer]") {
    const float entries = TRANSFER_TEXELS - 1, last_empty = std::floor(0.12f * entries);  // skin begins at 0.12
    // An empty half lies before it: blocks are looked up after an empty sample.
    load({16, 16, 16}, [&](int, int y, int) { return y < 8 ? (last_empty + 0.5f) / entries : 0.0f; });
    volume.transfer.set("skin");
    volume.steps.value = 64;
    volume.method.set("midpoint");
    const ImageRgb right = picture();
    REQUIRE(middle().g > 0.01f);
    volume.method.set("skipping");
    CHECK(mean_difference(right, picture()) == 0);
}

TEST_CASE_METHOD(OnVolume, "even matter is as opaque by the table as by its own opacity, also at an edge",
                 "[16.transfer]") {
    load({8, 8, 8}, [](int, int, int) { return 0.13f; });
    volume.transfer.set("skin");
    volume.density.value = 0.01f;
    volume.steps.value = 64;
    volume.method.set("midpoint");
    const double right = double(middle().g);
    REQUIRE(right > 0.01);
    volume.method.set("preintegrated");
    CHECK(double(middle().g) == Approx(right).epsilon(0.04));
}

TEST_CASE("a density of two lets through the square; a layer is as thin as its entries", "[16.transfer]") {
    CHECK(transfer_function("even", 2).back().a == Approx(1 - 0.8f * 0.8f));
    std::vector<glm::vec4> layer(256, glm::vec4(0));
    for (int i = 100; i < 110; ++i) layer[size_t(i)].a = 0.5f;
    CHECK(thinnest_layer(layer) == Approx(10.0f / 256));
}

TEST_CASE_METHOD(OnVolume, "each end of a trapezium colours the step as far as it is opaque", "[16.transfer]") {
    // Along the ray the density falls from 1 to 0.34 in one step: both are points of the function `nebula`. A scan's y
    // points to the camera.
    load({2, 2, 2}, [](int, int y, int) { return y ? 1.0f : 0.34f; });
    volume.transfer.set("nebula");
    volume.method.set("trapezium");
    volume.steps.value = 1;
    const glm::dvec3 found(middle());
    const glm::dvec3 front(3.0, 2.7, 2.2), back(0.9, 0.22, 0.75);
    const double thick = -std::log(1 - 0.16), thin = -std::log(1 - 0.022);
    const glm::dvec3 right = (thick * front + thin * back) / (thick + thin);
    CHECK(found.g / found.r == Approx(right.g / right.r).epsilon(0.01));
    CHECK(found.b / found.r == Approx(right.b / right.r).epsilon(0.01));
}

// Along the ray the density rises from 0 to 1 within a metre, and the function is opaque in a fiftieth of it.
TEST_CASE_METHOD(OnVolume, "the reference sees a layer that is thinner than its steps", "[16.transfer]") {
    load({2, 2, 2}, [](int, int y, int) { return y ? 1.0f : 0.0f; });
    background = {1, 1, 1, 1};
    volume.transfer.set("shell");
    volume.glow.value = 0;
    volume.method.set("exact");
    volume.truth_samples.value = 16;
    const std::vector<glm::vec4> entries = transfer_function("shell", 1);
    double depth = 0;
    constexpr int parts = 200000;
    for (int i = 0; i < parts; ++i) {
        const double at = (i + 0.5) / parts * double(entries.size() - 1);
        const size_t low = std::min(size_t(at), entries.size() - 2);
        const double opacity = glm::mix(double(entries[low].a), double(entries[low + 1].a), at - double(low));
        depth -= std::log(1 - opacity) / double(REFERENCE_M) / parts;
    }
    REQUIRE(std::exp(-depth) < 0.7);
    CHECK(double(middle().g) == Approx(std::exp(-depth)).epsilon(0.02));
}

TEST_CASE_METHOD(OnVolume, "where the density rises evenly, steps by their middle or both ends are exact",
                 "[16.transfer]") {
    load({2, 2, 2}, [](int, int y, int) { return y ? 1.0f : 0.0f; });
    background = {1, 1, 1, 1};
    camera.fov_y_rad = 0.06f;
    volume.transfer.set("even");
    volume.glow.value = 0;
    volume.density.value = 0.1f;
    // A metre that rises to density 1, and half a metre of it.
    const double a = even_opacity, rising = ((1 - a) * std::log(1 - a) + a) / a;
    const double depth = 0.1 / double(REFERENCE_M) * (rising - 0.5 * std::log(1 - a));
    volume.steps.value = 8;
    volume.truth_samples.value = 1;
    for (const char* method : {"midpoint", "skipping", "trapezium", "exact"}) {
        INFO(method);
        volume.method.set(method);
        CHECK(double(middle().g) == Approx(std::exp(-depth)).epsilon(0.012));
    }
}
