#include "common/app/gpu_load.h"

namespace lightwalk {
namespace {

const Pipeline busy = compute({.shader = "common/load.comp"});
constexpr double enough_ms = 2;

}  // namespace

void GpuLoad::run(std::chrono::milliseconds duration) {
    if (frame_.gpu.device.software()) return;
    if (!result_) result_ = Buffer(frame_.gpu.device, {.name = "load", .bytes = 16});
    const auto until = std::chrono::steady_clock::now() + duration;
    while (std::chrono::steady_clock::now() < until) {
        frame_.begin({4, 4}, 0);
        frame_.compute("load", {.reads = {}, .writes = {result_}}, [&](Compute& pass) {
            pass.use(busy).set("load", result_).dispatch({groups_, 1, 1});
        });
        frame_.end();
        if (frame_.times.at(0).gpu_ms < enough_ms && groups_ < 1u << 15) groups_ *= 2;
    }
}

}  // namespace lightwalk
