#include "common/gpu/gpu.h"

#include <cstdio>
#include <cstdlib>

#include "common/gpu/device_wait.h"
#include "common/gpu/gpu_work.h"

namespace lightwalk {

std::function<void(const std::string&)>& on_abandoned_device() {
    static std::function<void(const std::string&)> callback;
    return callback;
}

void abandon_device(const std::string& message) {
    if (on_abandoned_device()) on_abandoned_device()(message);
    std::fflush(stdout);
    std::fprintf(stderr, "error: %s\n", message.c_str());
    std::fflush(stderr);
    std::_Exit(1);
}

Gpu::Gpu(const DeviceOptions& options) : device(options) {
    const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                            .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                            .queueFamilyIndex = device.queue_family};
    check(vkCreateCommandPool(device.handle, &pool_info, nullptr, pool_.put(device.handle)), "vkCreateCommandPool");
    device.set_name(VK_OBJECT_TYPE_COMMAND_POOL, reinterpret_cast<uint64_t>(VkCommandPool(pool_)), "transfers");
}

Gpu::~Gpu() {
    vkDeviceWaitIdle(device.handle);
    pipelines.clear();
}

void Gpu::submit_now(const std::function<void(VkCommandBuffer)>& record) {
    const VkCommandBufferAllocateInfo allocate{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                               .commandPool = pool_,
                                               .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                               .commandBufferCount = 1};
    ++gpu_work.transfers;
    // One fence per call: threads may transfer concurrently.
    Owned<VkFence, vkDestroyFence> fence;
    const VkFenceCreateInfo fence_info{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    check(vkCreateFence(device.handle, &fence_info, nullptr, fence.put(device.handle)), "vkCreateFence");
    device.set_name(VK_OBJECT_TYPE_FENCE, reinterpret_cast<uint64_t>(VkFence(fence)), "transfer");
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device.handle, &allocate, &commands), "vkAllocateCommandBuffers");
    device.set_name(VK_OBJECT_TYPE_COMMAND_BUFFER, reinterpret_cast<uint64_t>(commands), "transfer");
    try {
        const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                             .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
        check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
        record(commands);
        check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
        const VkCommandBufferSubmitInfo command_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                                     .commandBuffer = commands};
        const VkSubmitInfo2 submit{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                                   .commandBufferInfoCount = 1,
                                   .pCommandBufferInfos = &command_info};
        check(vkQueueSubmit2(device.queue, 1, &submit, fence), "vkQueueSubmit2");
        const VkResult waited = wait_for(device, [&](uint64_t most_ns) {
            return vkWaitForFences(device.handle, 1, fence.address(), VK_TRUE, most_ns);
        });
        if (waited == VK_TIMEOUT)
            abandon_device(fmt::format("a transfer did not finish within {:.4g} s",
                                       static_cast<double>(device.timeout_ns()) / 1e9));
        check(waited, "vkWaitForFences");
    } catch (...) {
        vkDeviceWaitIdle(device.handle);  // resources in use are destroyed during unwinding
        vkFreeCommandBuffers(device.handle, pool_, 1, &commands);
        throw;
    }
    vkFreeCommandBuffers(device.handle, pool_, 1, &commands);
}

}  // namespace lightwalk
