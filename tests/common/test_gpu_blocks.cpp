// Uniform blocks, also where they are hidden from the driver.

#include "common/gpu/hidden_blocks.h"
#include "common/gpu/reflect.h"
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

namespace {

// Conditions on numbers of two blocks, each evaluated in its own way; the loop's count is known.
const std::string two_blocks = R"(
layout(local_size_x = 1) in;
layout(scalar) writeonly buffer CountsBuffer { int counts[]; };
layout(scalar) uniform WayBlock { float end; int most; } way;
layout(scalar) uniform StepBlock { float size; int stride; } by;
void main() {
    int turns = 0;
    for (float t = 0.0; t <= way.end && by.size <= way.end; t += by.size) ++turns;
    int strides = 0;
    for (int i = 0; i < way.most && by.stride > 0 && strides <= way.most; i += by.stride) ++strides;
    counts[0] = by.stride > way.most ? -1 : turns;
    counts[1] = way.end < by.size && by.stride == 1 ? -1 : strides;
    counts[2] = counts[3] = 0;
}
)";

struct WayNumbers {
    float end;
    int most;
};

struct StepNumbers {
    float size;
    int stride;
};

}  // namespace

TEST_CASE("a module with hidden blocks is valid") {
    const std::string header = "#version 460\n#extension GL_EXT_scalar_block_layout : require\n";
    std::vector<uint32_t> spirv = compile(Stage::compute, header + two_blocks, "two blocks");
    REQUIRE(reflect(spirv).bindings.size() == 3);
    const size_t words = spirv.size();
    hide_blocks(spirv);
    CHECK(spirv.size() > words);
    CHECK(validate_spirv(spirv) == "");
}

TEST_CASE_METHOD(OnDevice, "numbers of two blocks decide conditions together, and change from dispatch to dispatch") {
    const Pipeline count = compute_pipeline("count", two_blocks);
    const Buffer counts(gpu.device, {.name = "counts", .bytes = 16});
    for (const int most : {3, 7, 20, 1000}) {
        frame.compute("count", {.writes = {counts}}, [&](Compute& pass) {
            pass.use(count)
                .set("counts", counts)
                .set("way", WayNumbers{0.25f * float(most), most})
                .set("by", StepNumbers{0.25f, 3});
            pass.dispatch({1, 1, 1});
        });
        frame.end();
        const int strides = (most + 2) / 3;
        CHECK(read<int>(counts) == std::vector<int>{most + 1, strides, 0, 0});
        frame.begin({4, 4}, 0);
    }
    frame.end();
}
