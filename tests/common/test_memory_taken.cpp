// Memory that a program takes, counted by its own operator new.
#include <fmt/core.h>

#include <filesystem>

#include "blocks_taken.h"
#include "common/scene/gltf.h"
#include "common/scene/scene_file.h"
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

TEST_CASE("a model is read with few times its file's bytes") {
    for (const auto& [name, most] : {std::pair{"models/suzanne_family.glb", 10.5}, {"models/knot.glb", 5.5}}) {
        INFO(name);
        const std::filesystem::path file = find_asset(name);
        read_gltf(file);
        const size_t before = bytes_taken;
        const Model model = read_gltf(file);
        const double times = double(bytes_taken - before) / double(std::filesystem::file_size(file));
        INFO(times);
        CHECK(times < most);
    }
}

TEST_CASE_METHOD(DeviceTest, "recording a pass takes at most six blocks of memory, once there was one like it") {
    constexpr int passes = 20;
    const Pipeline twice = compute_pipeline("twice", R"(
layout(local_size_x = 1) in;
layout(scalar) uniform ByBlock { uint value; } by;
layout(scalar) readonly buffer FromBuffer { uint numbers[]; } from;
layout(scalar) buffer IntoBuffer { uint numbers[]; } into;
void main() { into.numbers[0] = by.value * from.numbers[0]; }
)");
    const Buffer from = gpu.upload("from", std::vector<uint32_t>(4, 3));
    const Buffer into(gpu.device, {.name = "into", .bytes = 16});
    size_t taken = 0;
    for (int i = 0; i < 4; ++i) {
        frame.begin({4, 4}, 0);
        const size_t before = blocks_taken;
        for (uint32_t k = 0; k < passes; ++k)
            frame.compute("twice", {.reads = {from}, .writes = {into}}, [&](Compute& pass) {
                pass.use(twice).set("from", from).set("into", into).set("by", k).dispatch({1, 1, 1});
            });
        frame.close();
        taken = blocks_taken - before;
        frame.end();
    }
    CHECK(read<uint32_t>(into)[0] == 3 * (passes - 1));
    INFO(taken);
    CHECK(taken <= 6 * passes);
}
