#include <fmt/core.h>

#include <array>
#include <utility>

#include "common/gpu/device_wait.h"
#include "common/gpu/frame.h"

namespace lightwalk {

void Frame::end(VkSemaphore wait, VkSemaphore signal) {
    if (!passes_.empty()) submit(wait, signal);
    for (const auto& state : read_backs_) state->bytes = state->recorded;
    read_backs_.clear();
    if (use_) gpu.device.end_use(std::exchange(use_, 0));
}

// Adds to `times`.
void Frame::submit(VkSemaphore wait, VkSemaphore signal) {
    const size_t count = passes_.size();
    const auto semaphore_info = [](VkSemaphore semaphore, uint64_t value) {
        return VkSemaphoreSubmitInfo{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                                     .semaphore = semaphore,
                                     .value = value,
                                     .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
    };
    std::vector<VkCommandBufferSubmitInfo> commands(count);
    std::vector<std::array<VkSemaphoreSubmitInfo, 2>> signals(count);
    std::vector<VkSubmitInfo2> submits(count);
    const VkSemaphoreSubmitInfo first_wait = semaphore_info(wait, 0);
    for (size_t i = 0; i < count; ++i) {
        commands[i] = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO, .commandBuffer = passes_[i].commands};
        signals[i] = {semaphore_info(timeline_, counted_ + i + 1), semaphore_info(signal, 0)};
        submits[i] = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                      .commandBufferInfoCount = 1,
                      .pCommandBufferInfos = &commands[i],
                      .signalSemaphoreInfoCount = 1,
                      .pSignalSemaphoreInfos = signals[i].data()};
    }
    if (wait) {
        submits.front().waitSemaphoreInfoCount = 1;
        submits.front().pWaitSemaphoreInfos = &first_wait;
    }
    if (signal) submits.back().signalSemaphoreInfoCount = 2;
    check(vkQueueSubmit2(gpu.device.queue, static_cast<uint32_t>(count), submits.data(), VK_NULL_HANDLE),
          "vkQueueSubmit2");
    wait_for_passes();
    read_times();
}

// For one after the other, so that the clock restarts with each: a frame of many passes may take its time.
void Frame::wait_for_passes() {
    for (const Recorded& pass : passes_) {
        const uint64_t target = counted_ + 1;
        const VkSemaphoreWaitInfo wait_info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO,
                                            .semaphoreCount = 1,
                                            .pSemaphores = timeline_.address(),
                                            .pValues = &target};
        const VkResult waited = wait_for(
            gpu.device, [&](uint64_t most_ns) { return vkWaitSemaphores(gpu.device.handle, &wait_info, most_ns); });
        if (waited == VK_TIMEOUT)
            abandon_device(
                fmt::format("pass '{}' did not end within {:.4} s; look for a loop without an end in its shaders",
                            pass.name, std::to_string(static_cast<double>(gpu.device.timeout_ns()) / 1e9)));
        check(waited, fmt::format("pass '{}'", pass.name).c_str());
        counted_ = target;
    }
}

void Frame::read_times() {
    std::vector<uint64_t> stamps(2 * passes_.size());
    check(vkGetQueryPoolResults(gpu.device.handle, queries_, 0, static_cast<uint32_t>(stamps.size()),
                                stamps.size() * sizeof(uint64_t), stamps.data(), sizeof(uint64_t),
                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "vkGetQueryPoolResults");
    const double tick_ms = static_cast<double>(gpu.device.properties.limits.timestampPeriod) * 1e-6;
    for (size_t i = 0; i < passes_.size(); ++i)
        times.push_back(
            {passes_[i].name, passes_[i].stage, static_cast<double>(stamps[2 * i + 1] - stamps[2 * i]) * tick_ms});
}

}  // namespace lightwalk
