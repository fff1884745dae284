#include "common/gpu/gpu.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "common/base/error.h"

namespace lightwalk {
namespace {

constexpr Access transfer_read{VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                               VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, false};
constexpr Access transfer_write{VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, true};
constexpr Access shader_read{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                             VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, false};

// True where a barrier is needed; updates the history to hold `next`.
bool advance(AccessHistory& history, const Access& next, bool image, Access& from) {
    const bool new_layout = image && history.layout != next.layout;
    from = history.last_write;
    if (next.writes || new_layout) {
        from.stages |= history.readers;
        history.last_write = next;
        history.readers = next.writes ? VK_PIPELINE_STAGE_2_NONE : next.stages;
        history.layout = next.layout;
        return new_layout || from.stages != VK_PIPELINE_STAGE_2_NONE;
    }
    if ((history.readers & next.stages) == next.stages) return false;
    history.readers |= next.stages;
    return from.stages != VK_PIPELINE_STAGE_2_NONE;
}

}  // namespace

void barrier(VkCommandBuffer commands, const Image& image, const Access& next) {
    const VkImageLayout old_layout = image.history.layout;
    Access from;
    if (!advance(image.history, next, true, from)) return;
    const VkImageMemoryBarrier2 one{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                    .srcStageMask = from.stages,
                                    .srcAccessMask = from.writes ? from.access : VK_ACCESS_2_NONE,
                                    .dstStageMask = next.stages,
                                    .dstAccessMask = next.access,
                                    .oldLayout = old_layout,
                                    .newLayout = next.layout,
                                    .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                    .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                    .image = image.handle,
                                    .subresourceRange = image.range()};
    const VkDependencyInfo info{
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &one};
    vkCmdPipelineBarrier2(commands, &info);
}

void barrier(VkCommandBuffer commands, const Buffer& buffer, const Access& next) {
    Access from;
    if (!advance(buffer.history, next, false, from)) return;
    const VkBufferMemoryBarrier2 one{.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2,
                                     .srcStageMask = from.stages,
                                     .srcAccessMask = from.writes ? from.access : VK_ACCESS_2_NONE,
                                     .dstStageMask = next.stages,
                                     .dstAccessMask = next.access,
                                     .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                     .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                     .buffer = buffer.handle,
                                     .size = VK_WHOLE_SIZE};
    const VkDependencyInfo info{
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .bufferMemoryBarrierCount = 1, .pBufferMemoryBarriers = &one};
    vkCmdPipelineBarrier2(commands, &info);
}

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
    check(vkCreateCommandPool(device.handle, &pool_info, nullptr, &pool_), "vkCreateCommandPool");
    const VkFenceCreateInfo fence_info{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    check(vkCreateFence(device.handle, &fence_info, nullptr, &fence_), "vkCreateFence");
}

Gpu::~Gpu() {
    vkDeviceWaitIdle(device.handle);
    pipelines.clear();
    vkDestroyFence(device.handle, fence_, nullptr);
    vkDestroyCommandPool(device.handle, pool_, nullptr);
}

void Gpu::submit_now(const std::function<void(VkCommandBuffer)>& record) {
    const VkCommandBufferAllocateInfo allocate{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                               .commandPool = pool_,
                                               .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                               .commandBufferCount = 1};
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device.handle, &allocate, &commands), "vkAllocateCommandBuffers");
    const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                         .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    record(commands);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    const VkCommandBufferSubmitInfo command_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                                 .commandBuffer = commands};
    const VkSubmitInfo2 submit{
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2, .commandBufferInfoCount = 1, .pCommandBufferInfos = &command_info};
    check(vkQueueSubmit2(device.queue, 1, &submit, fence_), "vkQueueSubmit2");
    const VkResult waited = vkWaitForFences(device.handle, 1, &fence_, VK_TRUE, device.timeout_ns());
    if (waited == VK_TIMEOUT) abandon_device("a transfer did not finish");
    check(waited, "vkWaitForFences");
    vkResetFences(device.handle, 1, &fence_);
    vkResetCommandPool(device.handle, pool_, 0);
    vkFreeCommandBuffers(device.handle, pool_, 1, &commands);
}

// [upload]
Buffer Gpu::upload(const std::string& name, std::span<const std::byte> bytes) {
    Buffer buffer(device, {.name = name, .bytes = bytes.size()});
    if (!bytes.empty()) {
        Buffer staging(device, {.name = name + " staging", .bytes = bytes.size(), .host_visible = true});
        std::memcpy(staging.mapped, bytes.data(), bytes.size());
        submit_now([&](VkCommandBuffer commands) {
            const VkBufferCopy region{.size = bytes.size()};
            barrier(commands, buffer, transfer_write);
            vkCmdCopyBuffer(commands, staging.handle, buffer.handle, 1, &region);
            barrier(commands, buffer, shader_read);
        });
        uploaded_bytes += bytes.size();
    }
    buffer.constant = true;
    return buffer;
}
// [/upload]

void Gpu::upload(Image& image, std::span<const std::byte> texels) {
    const Image::Desc& d = image.desc;
    Buffer staging(device, {.name = d.name + " staging", .bytes = texels.size(), .host_visible = true});
    std::memcpy(staging.mapped, texels.data(), texels.size());
    uploaded_bytes += texels.size();
    submit_now([&](VkCommandBuffer commands) {
        barrier(commands, image, transfer_write);
        const VkBufferImageCopy region{
            .imageSubresource = {.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .layerCount = d.layers},
            .imageExtent = {d.size.x, d.size.y, 1}};
        vkCmdCopyBufferToImage(commands, staging.handle, image.handle, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                               &region);
        if (d.mips > 1)
            barrier(commands, image,
                    {transfer_write.stages, VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
                     VK_IMAGE_LAYOUT_GENERAL, true});
        for (uint32_t mip = 1; mip < d.mips; ++mip) {
            const auto extent = [&](uint32_t level) {
                return VkOffset3D{int32_t(std::max(1u, d.size.x >> level)), int32_t(std::max(1u, d.size.y >> level)),
                                  1};
            };
            const VkImageBlit blit{.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip - 1, 0, d.layers},
                                   .srcOffsets = {{}, extent(mip - 1)},
                                   .dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, d.layers},
                                   .dstOffsets = {{}, extent(mip)}};
            vkCmdBlitImage(commands, image.handle, VK_IMAGE_LAYOUT_GENERAL, image.handle, VK_IMAGE_LAYOUT_GENERAL, 1,
                           &blit, VK_FILTER_LINEAR);
            barrier(commands, image,
                    {transfer_write.stages, VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
                     VK_IMAGE_LAYOUT_GENERAL, true});
        }
        barrier(commands, image, shader_read);
    });
    image.constant = true;
}

void Gpu::upload(Image& image, const std::vector<std::vector<std::byte>>& levels) {
    const Image::Desc& d = image.desc;
    VkDeviceSize bytes = 0;
    for (const auto& level : levels) bytes += level.size();
    Buffer staging(device, {.name = d.name + " staging", .bytes = bytes, .host_visible = true});
    std::vector<VkBufferImageCopy> regions;
    VkDeviceSize at = 0;
    for (uint32_t mip = 0; mip < d.mips; ++mip) {
        const auto& level = levels.at(mip);
        std::memcpy(staging.mapped + at, level.data(), level.size());
        regions.push_back({.bufferOffset = at,
                           .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, 1},
                           .imageExtent = {std::max(1u, d.size.x >> mip), std::max(1u, d.size.y >> mip), 1}});
        at += level.size();
    }
    uploaded_bytes += bytes;
    submit_now([&](VkCommandBuffer commands) {
        barrier(commands, image, transfer_write);
        vkCmdCopyBufferToImage(commands, staging.handle, image.handle, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, d.mips,
                               regions.data());
        barrier(commands, image, shader_read);
    });
    image.constant = true;
}

std::vector<std::byte> Gpu::read_back(const Image& image) {
    const VkDeviceSize bytes = VkDeviceSize(texel_bytes(image.desc.format)) * image.desc.size.x * image.desc.size.y;
    Buffer staging(device, {.name = "read back " + image.desc.name, .bytes = bytes, .host_visible = true});
    submit_now([&](VkCommandBuffer commands) {
        barrier(commands, image, transfer_read);
        const VkBufferImageCopy region{.imageSubresource = {.aspectMask = image.range().aspectMask, .layerCount = 1},
                                       .imageExtent = {image.desc.size.x, image.desc.size.y, 1}};
        vkCmdCopyImageToBuffer(commands, image.handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, staging.handle, 1,
                               &region);
        if (image.constant) barrier(commands, image, shader_read);
    });
    return {staging.mapped, staging.mapped + bytes};
}

std::vector<std::byte> Gpu::read_back(const Buffer& buffer) {
    Buffer staging(device, {.name = "read back " + buffer.name, .bytes = buffer.bytes, .host_visible = true});
    submit_now([&](VkCommandBuffer commands) {
        barrier(commands, buffer, transfer_read);
        const VkBufferCopy region{.size = buffer.bytes};
        vkCmdCopyBuffer(commands, buffer.handle, staging.handle, 1, &region);
    });
    return {staging.mapped, staging.mapped + buffer.bytes};
}

}  // namespace lightwalk
