// Samplers: comparing, borders, wrapping, mips; made once for each value.
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

namespace {

std::string reader(const std::string& declaration, const std::string& expression) {
    return "layout(local_size_x = 1) in;\nuniform " + declaration +
           " map;\nlayout(scalar) buffer SeenBuffer { float seen[]; };\nvoid main() { " + expression + " }\n";
}

}  // namespace

TEST_CASE_METHOD(OnDevice, "a comparing sampler answers 0 or 1, and its border counts as the border's colour") {
    const Image map = image({.format = VK_FORMAT_D32_SFLOAT, .size = {4, 4}, .kept = true});
    const Buffer seen(gpu.device, {.name = "seen", .bytes = 16});
    const Pipeline compare = compute_pipeline("compare", reader("sampler2DShadow", R"(
    seen[0] = textureLod(map, vec3(0.5, 0.5, 0.4), 0.0);
    seen[1] = textureLod(map, vec3(0.5, 0.5, 0.5), 0.0);
    seen[2] = textureLod(map, vec3(0.5, 0.5, 0.6), 0.0);
    seen[3] = textureLod(map, vec3(1.5, 0.5, 0.6), 0.0);
)"));
    frame.raster("depth", {.depth = clear(map, 0.5f)}, [](Raster&) {});
    const auto answers = [&](const Sampler& sampler) {
        frame.compute("compare", {.reads = {map}, .writes = {seen}}, [&](Compute& pass) {
            pass.use(compare).set("map", map, sampler).set("seen", seen).dispatch({1, 1, 1});
        });
        frame.end();
        frame.begin({4, 4}, 0);
        return read<float>(seen);
    };
    using Four = std::vector<float>;
    CHECK(answers({.compare = Compare::greater, .wrap = Wrap::clamp}) == Four{0, 0, 1, 1});
    CHECK(answers({.compare = Compare::greater_or_equal, .wrap = Wrap::clamp}) == Four{0, 1, 1, 1});
    CHECK(answers({.compare = Compare::less, .wrap = Wrap::clamp}) == Four{1, 0, 0, 0});
    CHECK(answers({.filter = Filter::nearest,
                   .compare = Compare::greater,
                   .wrap = Wrap::border,
                   .border = Border::opaque_white}) == Four{0, 0, 1, 0});
    CHECK(answers({.filter = Filter::nearest, .compare = Compare::greater, .wrap = Wrap::border}) == Four{0, 0, 1, 1});
}

TEST_CASE_METHOD(OnDevice, "wrapping, borders, filters and levels are as the sampler says") {
    Image map = image({.format = one_float, .size = {2, 1}, .mips = 2});
    const auto level = [](std::initializer_list<float> values) {
        std::vector<std::byte> bytes(4 * values.size());
        std::memcpy(bytes.data(), values.begin(), bytes.size());
        return bytes;
    };
    gpu.upload(map, {level({10, 20}), level({100})});
    const Buffer seen(gpu.device, {.name = "seen", .bytes = 16});
    const Pipeline look = compute_pipeline("wrap", reader("sampler2D", R"(
    seen[0] = textureLod(map, vec2(0.5, 0.5), 0.0).r;
    seen[1] = textureLod(map, vec2(-0.25, 0.5), 0.0).r;
    seen[2] = textureLod(map, vec2(1.1, 0.5), 0.0).r;
    seen[3] = textureLod(map, vec2(0.25, 0.5), 0.5).r;
)"));
    const auto seen_by = [&](const Sampler& sampler) {
        frame.compute("wrap", {.writes = {seen}}, [&](Compute& pass) {
            pass.use(look).set("map", map, sampler).set("seen", seen).dispatch({1, 1, 1});
        });
        frame.end();
        frame.begin({4, 4}, 0);
        return read<float>(seen);
    };
    const auto of = [&](Filter filter, Wrap wrap, Border border = Border::opaque_black) {
        return seen_by({.filter = filter, .wrap = wrap, .border = border});
    };
    CHECK(of(Filter::linear, Wrap::clamp)[0] == Approx(15));
    CHECK(of(Filter::nearest, Wrap::repeat)[1] == 20);
    CHECK(of(Filter::nearest, Wrap::repeat)[2] == 10);
    CHECK(of(Filter::nearest, Wrap::mirror)[1] == 10);
    CHECK(of(Filter::nearest, Wrap::mirror)[2] == 20);
    CHECK(of(Filter::nearest, Wrap::clamp)[1] == 10);
    CHECK(of(Filter::nearest, Wrap::border)[1] == 0);
    CHECK(of(Filter::nearest, Wrap::border, Border::opaque_white)[2] == 1);
    CHECK(of(Filter::nearest, Wrap::clamp)[3] == Approx(55));
    CHECK(seen_by({.mip_filter = Filter::nearest, .wrap = Wrap::clamp, .min_lod = 1})[0] == 100);
    CHECK(seen_by({.wrap = Wrap::clamp, .max_lod = 0})[3] == 10);
    CHECK(seen_by(nearest_repeat)[1] == 20);
    CHECK(seen_by(nearest_clamp)[1] == 10);
}

TEST_CASE_METHOD(OnDevice, "samplers that are equal are one") {
    Samplers samplers(gpu.device);
    const VkSampler first = samplers[linear_repeat];
    CHECK(samplers[Sampler{}] == first);
    CHECK(samplers[linear_clamp] != first);
    CHECK(samplers[Sampler{.anisotropy = 4}] != first);
    CHECK(samplers[Sampler{.wrap = Wrap::clamp}] == samplers[linear_clamp]);
    CHECK(samplers.size() == 3);
}
