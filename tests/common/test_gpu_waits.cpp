// Frames that take long: their times, and when a pass counts as endless.
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <thread>
#include <utility>

#include "common/gpu/device_wait.h"
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

namespace {
const Pipeline busy = compute_pipeline("busy", R"(
layout(local_size_x = 1) in;
layout(scalar) buffer OutBuffer { uint result; } work;
void main() {
    uint x = gl_GlobalInvocationID.x;
    for (int i = 0; i < 50000; ++i) x = x * 1664525u + 1013904223u;  // Mesa's software loops end after 65,535 rounds
    atomicAdd(work.result, x);
}
)");
}  // namespace

TEST_CASE_METHOD(OnDevice, "a frame that only computes is timed, also where one before it drew") {
    const Image drawn = image({.name = "drawn", .format = one_float, .size = {64, 64}});
    const Buffer out(gpu.device, {.name = "out", .bytes = 16});
    frame.raster("draw", {.color = {clear(drawn, glm::vec4(1))}}, [](Raster&) {});
    frame.end();
    for (uint32_t groups = 256;; groups *= 2) {
        frame.begin({4, 4}, 0);
        for (int i = 0; i < 2; ++i)
            frame.compute("busy", {.writes = {out}}, [&](Compute& pass) {
                pass.use(busy).set("work", out).dispatch({groups, 1, 1});
            });
        const auto begin = std::chrono::steady_clock::now();
        frame.end();
        const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        if (ms < 50 && groups < 1u << 20) continue;  // long compared with the cost of submitting
        CHECK(frame.times[0].gpu_ms > 0.05 * ms);
        CHECK(frame.times[1].gpu_ms > 0.05 * ms);
        break;
    }
}

TEST_CASE_METHOD(OnDevice, "the clock is for one pass, not for a frame") {
    const Buffer out(gpu.device, {.name = "out", .bytes = 16});
    const auto record = [&](int passes, uint32_t groups) {
        frame.begin({4, 4}, 0);
        for (int i = 0; i < passes; ++i)
            frame.compute("busy", {.writes = {out}}, [&](Compute& pass) {
                pass.use(busy).set("work", out).dispatch({groups, 1, 1});
            });
    };
    uint32_t groups = 16;
    for (record(1, groups), frame.end(); frame.times[0].gpu_ms < 50 && groups < 1u << 15; frame.end())
        record(1, groups *= 2);
    const double pass_s = 1e-3 * frame.times[0].gpu_ms;
    struct TooLong {};
    on_abandoned_device() = [](const std::string&) { throw TooLong(); };
    setenv("LIGHTWALK_TIMEOUT_S", std::to_string(8 * pass_s).c_str(), 1);
    record(24, groups);
    CHECK_NOTHROW(frame.end());
    setenv("LIGHTWALK_TIMEOUT_S", std::to_string(0.1 * pass_s).c_str(), 1);
    record(1, groups);
    CHECK_THROWS_AS(frame.end(), TooLong);
    unsetenv("LIGHTWALK_TIMEOUT_S");
    on_abandoned_device() = nullptr;
    vkDeviceWaitIdle(gpu.device.handle);
}

TEST_CASE_METHOD(OnDevice,
                 "a software path waits for a device while this process is given no time, ten times at most; a "
                 "hardware path waits once") {
    const bool before = std::exchange(gpu.device.software_paths, true);
    setenv("LIGHTWALK_TIMEOUT_S", "0.02", 1);
    int waits = 0;
    const auto starved = [&](int done_after) {
        waits = 0;
        return wait_for(gpu.device, [&](uint64_t most_ns) {
            std::this_thread::sleep_for(std::chrono::nanoseconds(most_ns));
            return ++waits < done_after ? VK_TIMEOUT : VK_SUCCESS;
        });
    };
    CHECK((starved(4) == VK_SUCCESS && waits == 4));
    CHECK((starved(100) == VK_TIMEOUT && waits == 10));
    waits = 0;
    const VkResult busy = wait_for(gpu.device, [&](uint64_t most_ns) {
        const std::clock_t end = std::clock() + static_cast<std::clock_t>(most_ns * CLOCKS_PER_SEC / 1'000'000'000);
        while (std::clock() <= end) {}
        ++waits;
        return VK_TIMEOUT;
    });
    CHECK((busy == VK_TIMEOUT && waits == 1));
    gpu.device.software_paths = false;
    CHECK((starved(4) == VK_TIMEOUT && waits == 1));
    gpu.device.software_paths = before;
    unsetenv("LIGHTWALK_TIMEOUT_S");
}
