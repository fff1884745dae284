// Tables made once on the device: a sphere of skin, and the facets' reflection.
#include "12_skin/truth.h"
#include "spread_fixture.h"

using namespace lightwalk;

namespace {

ImageRgb table(OnSpread& on, const char* shader, uint32_t side, float f0 = 0) {
    const Pipeline make = compute({.shader = shader});
    const Image image(on.gpu.device, {.name = "table", .size = glm::uvec2(side)});
    on.frame.begin({4, 4}, 0);
    on.frame.compute("table", {.writes = {image}}, [&](Compute& pass) {
        pass.use(make).set("result", image);
        if (pass.wants("f0")) pass.set("f0", f0);
        pass.dispatch_threads(image.desc.size);
    });
    on.frame.end();
    return read_linear(on.gpu, image);
}

}  // namespace

TEST_CASE_METHOD(OnSpread, "a sphere of skin shows all light that meets it, a flat one as much as Lambert's") {
    const ImageRgb found = table(*this, "12_skin/preintegrated.comp", 64);
    for (int y = 0; y < 64; ++y)
        for (int c = 0; c < 3; ++c) {
            double mean = 0;  // over the sphere: equal steps of the cosine are equal areas
            for (int x = 0; x < 64; ++x) mean += (x == 0 || x == 63 ? 0.5 : 1) * double(found.at(x, y)[c]) / 63;
            INFO(y << " " << c);
            CHECK(std::fabs(mean - 0.25) < 0.004);
        }
    for (int x = 0; x < 64; ++x) CHECK(std::fabs(double(found.at(x, 0).g) - std::max(2.0 * x / 63 - 1, 0.0)) < 0.002);
    // On a ball of 1 mm red goes all around, and blue hardly.
    CHECK(found.at(0, 63).r > 0.05f);
    CHECK(found.at(0, 63).b < 0.01f);
    CHECK(found.at(63, 63).r < 0.75f);
}

TEST_CASE_METHOD(OnSpread, "what facets reflect, as the device sums it up, is the integral of the BRDF") {
    for (const float f0 : {0.028f, 0.3f}) {
        const ImageRgb found = table(*this, "12_skin/reflected.comp", 32, f0);
        for (const int y : {6, 10, 20})
            for (const int x : {8, 16, 24, 31}) {
                const double right = truth::reflected(std::min(x / 31.0, 0.9999), y / 31.0, double(f0), 100);
                INFO(f0 << " " << x << " " << y);
                CHECK(std::fabs(double(found.at(x, y).r) - right) < 0.03 * right + 1e-4);
            }
        double mean = 0;
        for (int i = 0; i < 400; ++i) {
            const double at = 31 * (i + 0.5) / 400;
            const float low = found.at(int(at), 10).r, high = found.at(int(at) + 1, 10).r;
            mean += 2 * at / 31 * (double(low) + (at - int(at)) * double(high - low)) / 400;
        }
        CHECK(std::fabs(double(found.at(3, 10).g) - mean) < 0.02 * mean);
    }
}
