// Frames in flight: each has its own uploads, blocks and read-backs, and they end in order.
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

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
    CHECK(gpu.device.retired_count() == 0);
    return arrived;
}

}  // namespace

TEST_CASE_METHOD(OnDevice, "with one, two or three frames in flight each has its own data, and they end in order") {
    frame.end();
    std::vector<uint32_t> right;
    for (uint32_t i = 0; i < 20; ++i) right.push_back(1001 * i);
    for (const size_t in_flight : {1u, 2u, 3u, 2u, 1u}) {
        frame.set_frames_in_flight(in_flight);
        CHECK(sums_of(gpu, frame, 20) == right);
    }
}

TEST_CASE_METHOD(OnDevice, "of two frames in flight one may be abandoned, and one may be empty") {
    frame.end();
    frame.set_frames_in_flight(2);
    frame.begin({4, 4}, 0);
    frame.begin({4, 4}, 0);
    frame.end();
    CHECK(frame.times.empty());
    CHECK(sums_of(gpu, frame, 3) == std::vector<uint32_t>{0, 1001, 2002});
}
