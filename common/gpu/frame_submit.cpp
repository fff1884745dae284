#include <fmt/core.h>

#include <utility>

#include "common/gpu/device_wait.h"
#include "common/gpu/frame.h"

namespace lightwalk {

void Frame::end(VkSemaphore wait, VkSemaphore signal) {
    Recording& ended = recording();
    try {
        if (!ended.passes.empty()) submit(wait, signal);
    } catch (...) {
        vkDeviceWaitIdle(gpu.device.handle);  // resources in use are destroyed during unwinding
        throw;
    }
    if (ended.use) gpu.device.end_recording(ended.use);
    if (recordings_.size() == 1 || !ended.ends_at) return retire(ended);
    uint64_t counted = 0;
    check(vkGetSemaphoreCounterValue(gpu.device.handle, timeline_, &counted), "vkGetSemaphoreCounterValue");
    for (size_t i = 1; i <= recordings_.size(); ++i)
        if (Recording& one = *recordings_[(current_ + i) % recordings_.size()]; one.ends_at && one.ends_at <= counted)
            retire(one);
}

// Passes of a frame that is still being recorded are submitted and waited for, too; their read-backs have arrived.
void Frame::finish() {
    if (Recording& now = recording(); now.use && !now.ends_at && !now.passes.empty()) {
        submit(VK_NULL_HANDLE, VK_NULL_HANDLE);
        wait_for(now);
        now.read_times();
        now.ends_at = 0;
        now.deliver();
        now.restart();
    }
    for (size_t i = 1; i <= recordings_.size(); ++i)
        if (Recording& one = *recordings_[(current_ + i) % recordings_.size()]; one.ends_at) retire(one);
}

void Frame::set_frames_in_flight(size_t in_flight) {
    if (recordings_.size() == in_flight) return;
    finish();
    recordings_.resize(std::max<size_t>(in_flight, 1));
    for (auto& one : recordings_)
        if (!one) one = std::make_unique<Recording>(gpu.device);
    current_ = std::min(current_, recordings_.size() - 1);
}

void Frame::submit(VkSemaphore wait, VkSemaphore signal) {
    const auto semaphore_info = [](VkSemaphore semaphore, uint64_t value) {
        return VkSemaphoreSubmitInfo{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                                     .semaphore = semaphore,
                                     .value = value,
                                     .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
    };
    const VkCommandBufferSubmitInfo commands{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                             .commandBuffer = recording().close()};
    const VkSemaphoreSubmitInfo waits = semaphore_info(wait, 0),
                                signals[] = {semaphore_info(timeline_, submitted_ + 1), semaphore_info(signal, 0)};
    const VkSubmitInfo2 submit{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                               .waitSemaphoreInfoCount = wait ? 1u : 0u,
                               .pWaitSemaphoreInfos = &waits,
                               .commandBufferInfoCount = 1,
                               .pCommandBufferInfos = &commands,
                               .signalSemaphoreInfoCount = signal ? 2u : 1u,
                               .pSignalSemaphoreInfos = signals};
    const VkResult submitted = vkQueueSubmit2(gpu.device.queue, 1, &submit, VK_NULL_HANDLE);
    if (submitted == VK_SUCCESS) recording().ends_at = ++submitted_;  // must be waited for, whatever fails next
    check(submitted, "vkQueueSubmit2");
}

// The time limit applies per pass: it restarts whenever one ends.
void Frame::wait_for(const Recording& one) {
    const VkSemaphoreWaitInfo wait_info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO,
                                        .semaphoreCount = 1,
                                        .pSemaphores = timeline_.address(),
                                        .pValues = &one.ends_at};
    for (size_t ended = 0;;) {
        const VkResult waited = lightwalk::wait_for(
            gpu.device, [&](uint64_t most_ns) { return vkWaitSemaphores(gpu.device.handle, &wait_info, most_ns); });
        if (waited != VK_TIMEOUT) return check(waited, one.passes.back().name.c_str());
        const size_t now = one.ended_passes();
        const double limit_s = static_cast<double>(gpu.device.timeout_ns()) / 1e9;
        if (now == one.passes.size() && now == ended)
            abandon_device(fmt::format("the frame did not end within {} s of its last pass", limit_s));
        if (now == ended)
            abandon_device(
                fmt::format("pass '{}' did not end within {} s; look for a loop without an end in its shaders",
                            one.passes[now].name, limit_s));
        ended = now;
    }
}

void Frame::retire(Recording& one) {
    if (one.ends_at) {
        wait_for(one);
        one.read_times();
        one.ends_at = 0;
    }
    one.deliver();
    if (!one.use) return;
    times = std::exchange(one.times, {});
    gpu.device.end_use(std::exchange(one.use, 0));
    if (on_ended) on_ended(times);
}

}  // namespace lightwalk
