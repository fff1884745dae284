// Who reads what another pass wrote.
#include "common/window/frame_flow.h"
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

namespace {

const Pipeline fill_mip = compute_pipeline("fill mip", R"(
layout(local_size_x = 1) in;
layout(rgba16f) writeonly uniform image2D result;
void main() { imageStore(result, ivec2(gl_GlobalInvocationID.xy), vec4(1.0)); }
)");
const Pipeline halve = compute_pipeline("halve", R"(
layout(local_size_x = 1) in;
uniform sampler2D source;
layout(rgba16f) writeonly uniform image2D result;
void main() { imageStore(result, ivec2(gl_GlobalInvocationID.xy), textureLod(source, vec2(0.5), 0.0)); }
)");

using Edges = std::vector<std::pair<std::string, std::string>>;

Edges names(const FrameFlow& flow) {
    Edges result;
    const auto nodes = flow.nodes();
    for (const auto& edge : flow.edges()) result.emplace_back(nodes[edge.from].name, nodes[edge.to].name);
    return result;
}

}  // namespace

// A chain of mips, each made of the one before: two passes that touch other mips of the same image have no edge.
TEST_CASE("a pass is joined to those that wrote what it reads, by mip", "[passes]") {
    Gpu gpu{DeviceOptions{.validate = true}};
    FrameFlow flow;
    flow.own_pass = "small image";
    Frame frame(gpu, {.listener = &flow});
    flow.frame = &frame;
    flow.on = true;
    Image chain(gpu.device,
                {.name = "chain", .format = VK_FORMAT_R16G16B16A16_SFLOAT, .size = {8, 8}, .mips = 3, .kept = true});
    const auto record = [&] {
        frame.begin({8, 8}, 0);
        frame.compute("first", {.writes = {chain.mip(0)}}, [&](Compute& pass) {
            pass.use(fill_mip).set("result", chain.mip(0)).dispatch({8, 8, 1});
        });
        for (uint32_t m = 1; m < 3; ++m)
            frame.compute("level " + std::to_string(m), {.reads = {chain.mip(m - 1)}, .writes = {chain.mip(m)}},
                          [&](Compute& pass) {
                              pass.use(halve).set("source", chain.mip(m - 1)).set("result", chain.mip(m));
                              pass.dispatch({8u >> m, 8u >> m, 1});
                          });
        for (int i = 0; i < 2; ++i)
            frame.raster("last", {.color = {i == 0 ? clear(frame.hdr) : keep(frame.hdr)}, .reads = {chain.mip(2)}},
                         [](Raster&) {});
        frame.compute("small image", {.reads = {frame.hdr}, .writes = {chain.mip(0)}}, [&](Compute& pass) {
            pass.use(fill_mip).set("result", chain.mip(0)).dispatch({8, 8, 1});
        });
        frame.end();
    };
    for (int again = 0; again < 2; ++again) {  // a second frame replaces the first
        record();
        CHECK(names(flow) == Edges{{"first", "level 1"}, {"level 1", "level 2"}, {"level 2", "last"}});
        const auto nodes = flow.nodes();
        REQUIRE(nodes.size() == 4);
        CHECK(nodes[3].passes == 2);
        CHECK(nodes[0].stage == "compute");
        CHECK(nodes[3].gpu_ms == frame.times[3].gpu_ms + frame.times[4].gpu_ms);
        REQUIRE(nodes[1].outputs.size() == 1);
        CHECK(frame.outputs[nodes[1].outputs[0]].first == "level 1");
    }
    flow.on = false;
    record();
    CHECK(flow.nodes().size() == 4);  // as they were: nothing is noted
    gpu.device.check_validation();
}
