// Within a pass: indirect draws and dispatches, slots, descriptor sets.

#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

namespace {

const Pipeline add_one = compute_pipeline("add one", R"(
layout(local_size_x = 64) in;
layout(scalar) buffer ValuesBuffer { uint values[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    uint old = values[(i + 1u) % values.length()];
    barrier();
    values[i] = old + 1u;
}
)");

const Pipeline grow = compute_pipeline("grow", R"(
layout(local_size_x = 1) in;
layout(scalar) buffer CountBuffer { uint groups[3]; uint sum; } count;
void main() { atomicAdd(count.sum, 1u); if (gl_GlobalInvocationID.x == 0u) count.groups[0] = 5u; }
)");

}  // namespace

TEST_CASE_METHOD(OnDevice, "two sets of macros with equal hashes are two pipelines", "[pipeline_key]") {
    const Pipeline writes = compute_pipeline("named", R"(
layout(local_size_x = 1) in;
layout(scalar) buffer CountBuffer { uint groups[3]; uint sum; } count;
void main() {
#ifdef NAMED
    count.sum = 1u;
#endif
}
)");
    const Macros named{{"NAMED", "1==1"}}, other{{"NAMED=1", "=1"}};
    REQUIRE(named.hash() == other.hash());
    const Macros *first[] = {&named}, *second[] = {&other};
    const BuiltPipeline* const built = gpu.pipelines.get(writes, {}, first);
    CHECK(gpu.pipelines.get(writes, {}, second) != built);
    CHECK(gpu.pipelines.get(writes, {}, first) == built);
}

TEST_CASE_METHOD(OnDevice, "what a shader declares and main() does not reach need not be set, and may be") {
    const Pipeline part = compute_pipeline("part", R"(
layout(local_size_x = 4, local_size_y = 4) in;
uniform sampler2D absent;
layout(scalar) uniform AbsentBlock { vec4 color; } missing;
layout(scalar) uniform NumberBlock { float number; };
layout(r32f) writeonly uniform image2D into;
vec4 not_called() { return missing.color * textureLod(absent, vec2(0.5), 0.0); }
void main() { imageStore(into, ivec2(gl_GlobalInvocationID.xy), vec4(number)); }
)");
    const Image into = image({.name = "into", .format = one_float, .size = {4, 4}});
    const auto record = [&](const std::function<void(Compute&)>& set) {
        frame.compute("part", {.writes = {into}}, [&](Compute& pass) {
            set(pass.use(part).set("into", into));
            pass.dispatch_threads(frame.size);
        });
    };
    CHECK(failure_of([&] { record([](Compute&) {}); }) ==
          "pass 'part' draws or dispatches without 'number' being set; is its module stated in .with?");
    CHECK(failure_of([&] { record([](Compute& pass) { pass.set("nobody", 1.0f); }); }) ==
          "pass 'part': its shaders have no binding 'nobody'; they have: into, number, absent, missing");
    record([](Compute& pass) {
        pass.set("number", 2.0f).set("missing", glm::vec4(1)).set_if_present("missing", glm::vec4(1));
    });
    frame.end();
    CHECK(value(into) == 2);
}

TEST_CASE_METHOD(OnDevice, "what a pass discards is seen where a frame shows it") {
    const Image number = image({.name = "number", .format = one_float, .size = {4, 4}});
    frame.end();
    for (const bool shows : {false, true}) {
        Frame other(gpu, {.shows_discarded = shows});
        other.begin({4, 4}, 0);
        other.raster("fill", {.color = {clear(number, glm::vec4(3))}, .depth = clear(other.depth, 0.5f)},
                     [](Raster&) {});
        other.raster("discards", {.color = {discard(number)}, .depth = discard(other.depth)}, [](Raster&) {});
        other.end();
        if (shows) CHECK(value(number) == 1000);
        if (shows) CHECK(value(other.depth) == 1);
    }
}

TEST_CASE_METHOD(OnDevice, "a dispatch sees what the one before wrote, and how many groups it said") {
    const Buffer count(gpu.device, {.name = "count", .bytes = 16});
    const Buffer values = gpu.upload("values", std::vector<uint32_t>(64, 0));
    frame.transfer("zero", {.reads = {}, .writes = {count}},
                   [&](VkCommandBuffer commands) { vkCmdFillBuffer(commands, count.handle, 0, VK_WHOLE_SIZE, 1); });
    frame.compute("groups", {.reads = {count}, .writes = {count}}, [&](Compute& pass) {
        pass.use(grow).set("count", count).dispatch({1, 1, 1}).wait();
        pass.dispatch_indirect(count);
        CHECK(failure_of([&] { pass.dispatch_indirect(count, 8); }) ==
              "pass 'groups': no dispatch at byte 8 of 'count'");
    });
    frame.compute("values", {.reads = {values}, .writes = {values}}, [&](Compute& pass) {
        for (int i = 0; i < 100; ++i) pass.use(add_one).set("values", values).dispatch({1, 1, 1}).wait();
        CHECK(failure_of([&] { pass.dispatch_indirect(count); }) ==
              "pass 'values' binds 'count' without stating it in its reads");
    });
    frame.end();
    CHECK(read<uint32_t>(count)[3] == 1 + 1 + 5);
    CHECK(read<uint32_t>(values) == std::vector<uint32_t>(64, 100));
}

TEST_CASE_METHOD(OnDevice, "draws come from a buffer") {
    const Buffer count(gpu.device, {.name = "count", .bytes = 16});
    const Buffer draws =
        gpu.upload("draws", std::vector<VkDrawIndirectCommand>{{6, 1, 0, 0}, {0, 1, 0, 0}, {6, 3, 0, 0}});
    const Buffer indexed = gpu.upload("indexed", std::vector<VkDrawIndexedIndirectCommand>{{3, 2, 0, 0, 0}});
    const Buffer indices = gpu.upload("indices", std::vector<uint32_t>{0, 1, 2});
    const Pipeline counts = quad_pipeline({}, "count.frag");
    const auto fragments = [&](const std::function<void(Raster&)>& draw) {
        frame.begin({4, 4}, 0);
        frame.transfer("zero", {.reads = {}, .writes = {count}},
                       [&](VkCommandBuffer commands) { vkCmdFillBuffer(commands, count.handle, 0, VK_WHOLE_SIZE, 0); });
        frame.raster("count", {.reads = {count}, .writes = {count}}, [&](Raster& pass) {
            pass.use(counts).set("quad", Quad{}).set("count", count);
            draw(pass);
        });
        frame.end();
        return read<uint32_t>(count)[0];
    };
    CHECK(fragments([&](Raster& pass) { pass.draw_indirect(draws, 3); }) == 16 * 4);
    CHECK(fragments([&](Raster& pass) { pass.draw_indirect(draws, 1, 2 * sizeof(VkDrawIndirectCommand)); }) == 16 * 3);
    const uint32_t triangle = fragments([&](Raster& pass) { pass.draw_indexed(indices, 0, 3); });
    CHECK(triangle > 0);
    CHECK(fragments([&](Raster& pass) { pass.draw_indexed_indirect(indices, indexed); }) == 2 * triangle);
    fragments([&](Raster& pass) {
        CHECK(failure_of([&] { pass.draw_indirect(draws, 4); }) ==
              "pass 'count': 4 indirect draws from byte 0 on are not in 'draws'");
    });
}

TEST_CASE_METHOD(OnDevice, "a slot stands for a name; an empty one sets nothing; one of another pipeline is refused") {
    const Buffer values = gpu.upload("values", std::vector<uint32_t>(64, 0));
    const Buffer count(gpu.device, {.name = "count", .bytes = 16});
    frame.compute("slots", {.writes = {values, count}}, [&](Compute& pass) {
        pass.use(add_one);
        const auto slot = pass.slot("values");
        CHECK(slot);
        CHECK_FALSE(pass.slot("absent"));
        pass.set(pass.slot("absent"), values).set(slot, values).dispatch({1, 1, 1});
        pass.use(grow);
        CHECK(failure_of([&] { pass.set(slot, values); }) ==
              "pass 'slots' sets a slot of a pipeline that is not in use any more");
        pass.use(add_one);
        CHECK(failure_of([&] {
                  pass.dispatch({1, 1, 1});
              }) == "pass 'slots' draws or dispatches without 'values' being set");
    });
    frame.end();
    CHECK(read<uint32_t>(values)[0] == 1);
}

TEST_CASE_METHOD(DeviceTest, "more draws than a pool has sets, with other buffers each, draw with their own") {
    const Pipeline sum = quad_pipeline({.cull = VK_CULL_MODE_NONE, .blend = Blend::add}, "sum.frag");
    const Image target = image({.format = four_floats, .size = {1, 1}});
    const Buffer a = gpu.upload("a", std::vector<float>(4, 3)), b = gpu.upload("b", std::vector<float>(4, 4));
    for (int repeat = 0; repeat < 3; ++repeat) {
        frame.begin({1, 1}, 0);
        frame.raster("sum", {.color = {clear(target, glm::vec4(0))}}, [&](Raster& pass) {
            pass.use(sum).set("quad", Quad{}).set("first", a);
            for (int i = 0; i < 600; ++i) pass.set("second", i % 2 ? b : a).draw(6);
        });
        frame.end();
        CHECK(read<float>(target).at(0) == 300 * (3 + 3) + 300 * (3 + 4));
    }
}

TEST_CASE("sets follow other buffers, other pipelines, and what has the handle of something destroyed") {
    Gpu gpu(validated());
    const Pipeline sum = quad_pipeline({}, "sum.frag"), paint = quad_pipeline({});
    const Image target(gpu.device, {.name = "target", .format = four_floats, .size = {1, 1}});
    Frame frame(gpu);
    const auto drawn = [&](float first, float second, bool paints) {
        const Buffer a = gpu.upload("a", std::vector<float>(4, first)),
                     b = gpu.upload("b", std::vector<float>(4, second));
        frame.begin({1, 1}, 0);
        frame.raster("sum", {.color = {target}}, [&](Raster& pass) {
            if (paints) pass.use(paint).set("quad", Quad{}).set("paint", Paint{}).draw(6);
            pass.use(sum).set("quad", Quad{}).set("first", a).set("second", b).draw(6);
        });
        frame.end();
        float texel = 0;
        std::memcpy(&texel, gpu.read_back(target).data(), 4);
        return texel;
    };
    for (int i = 0; i < 8; ++i) CHECK(drawn(float(i), 10, i % 3 == 1) == float(i) + 10);
    CHECK_NOTHROW(gpu.device.check_validation());
}
