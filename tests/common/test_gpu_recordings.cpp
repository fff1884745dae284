// Frames in flight: each has its own uploads, blocks and read-backs, and they end in order.
#include <dlfcn.h>

#include <thread>

#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

namespace {

int command_buffers = 0;  // begun by anybody in this program

}  // namespace

// The loader's function of this name is called by way of this one.
extern "C" VkResult vkBeginCommandBuffer(VkCommandBuffer commands, const VkCommandBufferBeginInfo* info) {
    static const auto loaded = reinterpret_cast<PFN_vkBeginCommandBuffer>(dlsym(RTLD_NEXT, "vkBeginCommandBuffer"));
    ++command_buffers;
    return loaded(commands, info);
}

namespace {

const Pipeline add_up = compute_pipeline("sum", R"(
layout(local_size_x = 1) in;
layout(scalar) uniform AddBlock { uint value; } add;
layout(scalar) readonly buffer ValuesBuffer { uint values[]; };
layout(scalar) buffer TotalBuffer { uint sum; } total;
void main() {
    uint sum = add.value;
    for (int i = 0; i < values.length(); ++i) sum += values[i];
    total.sum = sum;
}
)");

// Of frames with these numbers: what each one's shader summed, as it arrives.
std::vector<uint32_t> sums_of(Gpu& gpu, Frame& frame, uint32_t frames) {
    Buffer values;
    const Buffer added(gpu.device, {.name = "added", .bytes = 16});
    ReadBack read;
    std::vector<uint32_t> arrived;
    frame.on_ended = [&](const std::vector<PassTime>& times) {
        REQUIRE(times.size() == 3);
        CHECK(times[0].name == "values");
        CHECK(times[1].name == "sum");
        arrived.push_back(read.as<uint32_t>().at(0));
    };
    for (uint32_t i = 0; i < frames; ++i) {
        frame.begin({4, 4}, 0);
        frame.upload("values", values, std::vector<uint32_t>(1000, i));
        {
            const Buffer gone = gpu.upload("gone", std::vector<uint32_t>(10, 1));
            frame.compute("sum", {.writes = {added}}, [&](Compute& pass) {
                pass.use(add_up).set("values", values).set("total", added).set("add", i).dispatch({1, 1, 1});
            });
        }
        frame.read_back(added, read);
        frame.end();
    }
    frame.finish();
    frame.on_ended = nullptr;
    CHECK(gpu.device.doomed_count() == 0);
    return arrived;
}

}  // namespace

TEST_CASE_METHOD(OnDevice, "with one, two or three frames in flight each has its own data, and they end in order") {
    frame.end();
    std::vector<uint32_t> right;
    for (uint32_t i = 0; i < 20; ++i) right.push_back(1001 * i);
    for (const size_t in_flight : {1u, 2u, 3u, 2u, 1u}) {
        frame.fly(in_flight);
        CHECK(sums_of(gpu, frame, 20) == right);
    }
}

TEST_CASE_METHOD(OnDevice, "of two frames in flight one may be abandoned, and one may be empty") {
    frame.end();
    frame.fly(2);
    frame.begin({4, 4}, 0);
    frame.begin({4, 4}, 0);
    frame.end();
    CHECK(frame.times.empty());
    CHECK(sums_of(gpu, frame, 3) == std::vector<uint32_t>{0, 1001, 2002});
}

namespace {

// Frames of a sum and its read-back, as one records them again and again.
struct Sums {
    explicit Sums(Gpu& device = validated_device()) : gpu(device) {}
    ~Sums() { CHECK_NOTHROW(gpu.device.check_validation()); }
    Gpu& gpu;
    Frame frame{gpu};
    Buffer added{gpu.device, {.name = "added", .bytes = 16}};
    Buffer values = gpu.upload("values", std::vector<uint32_t>(10, 7));
    ReadBack read;
    uint32_t each = 7;

    uint32_t frame_of(uint32_t plus, bool twice = false) {
        frame.begin({4, 4}, 0);
        for (int i = 0; i < (twice ? 2 : 1); ++i)
            frame.compute("sum", {.writes = {added}}, [&](Compute& pass) {
                pass.use(add_up).set("values", values).set("total", added).set("add", plus).dispatch({1, 1, 1});
            });
        frame.read_back(added, read);
        frame.end();
        frame.finish();
        return read.as<uint32_t>().at(0);
    }
    int recorded_for(uint32_t plus, bool twice = false) {
        const int before = command_buffers;
        CHECK(frame_of(plus, twice) == 10 * each + plus);
        return command_buffers - before;
    }
};

}  // namespace

TEST_CASE_METHOD(Sums, "a frame of the same commands as an earlier one records none, whatever its blocks hold") {
    for (uint32_t i = 0; i < 4; ++i) frame_of(i);
    for (uint32_t i = 0; i < 6; ++i) CHECK(recorded_for(i) == 0);
    CHECK(recorded_for(1, true) == 1);
    CHECK(recorded_for(2) == 0);  // the one before is still there
    for (uint32_t i = 0; i < 4; ++i) recorded_for(i, true);
    CHECK(recorded_for(2, true) == 0);
    frame.fly(2);
    for (uint32_t i = 0; i < 8; ++i) frame_of(i);
    for (uint32_t i = 0; i < 6; ++i) CHECK(recorded_for(i) == 0);
}

// Validation layers give each object a handle of its own.
TEST_CASE("a buffer that took the place of another one is bound, though its handle is the same", "[recorded.handles]") {
    DeviceOptions silent = validated();
    silent.validate = false;
    Gpu gpu(silent);
    Sums sums(gpu);
    for (uint32_t i = 0; i < 4; ++i) sums.frame_of(i);
    for (sums.each = 8; sums.each < 14; ++sums.each) {
        const VkBuffer handle = sums.values.handle;
        const uint64_t before = gpu.device.destroyed();
        sums.values = Buffer();
        CHECK(gpu.device.destroyed() > before);
        std::vector<Buffer> others;  // until an allocator gives the handle back, if it does
        while (sums.values.handle != handle && others.size() < 100) {
            others.push_back(std::move(sums.values));
            sums.values = gpu.upload("values", std::vector<uint32_t>(10, sums.each));
        }
        CHECK(sums.recorded_for(1) == 1);
        for (uint32_t i = 0; i < 3; ++i) sums.recorded_for(i);
        CHECK(sums.recorded_for(2) == 0);
    }
}

TEST_CASE("pipelines that another thread destroyed are bound anew, though their handles may be the same",
          "[recorded.handles]") {
    DeviceOptions silent = validated();
    silent.validate = false;
    Gpu gpu(silent);
    Sums sums(gpu);
    for (uint32_t i = 0; i < 4; ++i) sums.frame_of(i);
    for (int repeat = 0; repeat < 3; ++repeat) {
        const uint64_t before = gpu.device.destroyed();
        std::thread([&] { gpu.pipelines.clear(); }).join();
        CHECK(gpu.device.destroyed() > before);
        CHECK(sums.recorded_for(1) == 1);
        for (uint32_t i = 0; i < 3; ++i) sums.recorded_for(i);
        CHECK(sums.recorded_for(2) == 0);
    }
}

// With no descriptors pushed, each draw has a set: one that is written again has ended the command buffers that bind it.
TEST_CASE("frames whose descriptor sets change record anew", "[recorded.sets]") {
    Gpu gpu(validated(0));
    {
        Frame frame(gpu);
        const Buffer a = gpu.upload("a", std::vector<uint32_t>(4, 5)), b = gpu.upload("b", std::vector<uint32_t>(4, 6));
        const Buffer added(gpu.device, {.name = "added", .bytes = 16});
        ReadBack read;
        for (const Buffer* values : {&a, &a, &b, &a, &b, &b, &a, &a, &a, &b}) {
            frame.begin({4, 4}, 0);
            frame.compute("sum", {.writes = {added}}, [&](Compute& pass) {
                pass.use(add_up).set("values", *values).set("total", added).set("add", 1u).dispatch({1, 1, 1});
            });
            frame.read_back(added, read);
            frame.end();
            CHECK(read.as<uint32_t>().at(0) == (values == &a ? 21 : 25));
        }
    }
    CHECK_NOTHROW(gpu.device.check_validation());
}

TEST_CASE_METHOD(Sums, "commands that go in at once are recorded in every frame, the others around them are not") {
    const auto draw = [&](uint32_t count) {
        frame.begin({4, 4}, 0);
        frame.transfer("at once", {.writes = {added}}, [&](VkCommandBuffer commands) {
            vkCmdFillBuffer(commands, added.handle, 0, VK_WHOLE_SIZE, count);
        });
        frame.read_back(added, read);
        frame.end();
        return read.as<uint32_t>().at(0);
    };
    for (uint32_t i = 0; i < 4; ++i) draw(i);
    for (uint32_t i = 0; i < 4; ++i) {
        const int before = command_buffers;
        CHECK(draw(i) == i);
        CHECK(command_buffers - before == 1);
    }
}
