#include "common/gpu/barrier.h"

#include <algorithm>

namespace lightwalk {
namespace {

bool covers(VkPipelineStageFlags2 stages, VkPipelineStageFlags2 wanted) {
    return stages & VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT || (stages & wanted) == wanted;
}

// Updates the history with `next`. True if a barrier is needed, from the access `from`.
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
    if (covers(history.readers, next.stages)) return false;
    history.readers |= next.stages;
    return from.stages != VK_PIPELINE_STAGE_2_NONE;
}

// Appends a barrier, or extends an existing one that differs only by an adjacent subresource range.
void append(std::vector<VkImageMemoryBarrier2>& list, size_t first, const VkImageMemoryBarrier2& one) {
    for (size_t i = first; i < list.size(); ++i) {
        VkImageMemoryBarrier2& other = list[i];
        VkImageSubresourceRange &a = other.subresourceRange, b = one.subresourceRange;
        if (other.srcStageMask != one.srcStageMask || other.srcAccessMask != one.srcAccessMask ||
            other.oldLayout != one.oldLayout)
            continue;
        const bool same_mips = a.baseMipLevel == b.baseMipLevel && a.levelCount == b.levelCount;
        const bool same_layers = a.baseArrayLayer == b.baseArrayLayer && a.layerCount == b.layerCount;
        if (same_mips && a.baseArrayLayer + a.layerCount == b.baseArrayLayer) {
            a.layerCount += b.layerCount;
            return;
        }
        if (same_layers && a.baseMipLevel + a.levelCount == b.baseMipLevel) {
            a.levelCount += b.levelCount;
            return;
        }
    }
    list.push_back(one);
}

}  // namespace

void Barriers::add(const ImageView& view, const Access& next) {
    ImageHistory& history = view.image->history;
    VkImageSubresourceRange range = view.range();
    if (view.is_volume()) {
        range.baseArrayLayer = 0;  // depth slices share one subresource
        range.layerCount = 1;
    }
    Access from;
    const auto make = [&](VkImageLayout old_layout, const VkImageSubresourceRange& part) {
        return VkImageMemoryBarrier2{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                     .srcStageMask = from.stages,
                                     .srcAccessMask = from.writes ? from.access : VK_ACCESS_2_NONE,
                                     .dstStageMask = next.stages,
                                     .dstAccessMask = next.access,
                                     .oldLayout = old_layout,
                                     .newLayout = next.layout,
                                     .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                     .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                     .image = view.image->handle,
                                     .subresourceRange = part};
    };
    const uint32_t mips = view.image->desc.mips, layers = view.image->desc.layers;
    const bool whole = range.levelCount == mips && range.layerCount == layers;
    if (history.each.empty()) {
        AccessHistory after = history.all;
        const bool needed = advance(after, next, true, from);
        if (whole || after == history.all) {
            if (needed) images.push_back(make(history.all.layout, range));
            history.all = after;
            return;
        }
        history.each.assign(size_t(mips) * layers, history.all);
    }
    const size_t first = images.size();
    std::vector<VkImageMemoryBarrier2> of_mip;
    for (uint32_t mip = range.baseMipLevel; mip < range.baseMipLevel + range.levelCount; ++mip) {
        of_mip.clear();
        for (uint32_t layer = range.baseArrayLayer; layer < range.baseArrayLayer + range.layerCount; ++layer) {
            AccessHistory& one = history.each[size_t(mip) * layers + layer];
            const VkImageLayout old_layout = one.layout;
            if (advance(one, next, true, from))
                append(of_mip, 0, make(old_layout, {range.aspectMask, mip, 1, layer, 1}));
        }
        for (const VkImageMemoryBarrier2& one : of_mip) append(images, first, one);
    }
    if (std::all_of(history.each.begin(), history.each.end(),
                    [&](const AccessHistory& h) { return h == history.each[0]; })) {
        history.all = history.each[0];
        history.each.clear();
    }
}

void Barriers::add(const Buffer& buffer, const Access& next) {
    Access from;
    if (!advance(buffer.history, next, false, from)) return;
    buffers.push_back({.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2,
                       .srcStageMask = from.stages,
                       .srcAccessMask = from.writes ? from.access : VK_ACCESS_2_NONE,
                       .dstStageMask = next.stages,
                       .dstAccessMask = next.access,
                       .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                       .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                       .buffer = buffer.handle,
                       .size = VK_WHOLE_SIZE});
}

void Barriers::record(VkCommandBuffer commands) {
    if (images.empty() && buffers.empty()) return;
    const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                .bufferMemoryBarrierCount = static_cast<uint32_t>(buffers.size()),
                                .pBufferMemoryBarriers = buffers.data(),
                                .imageMemoryBarrierCount = static_cast<uint32_t>(images.size()),
                                .pImageMemoryBarriers = images.data()};
    vkCmdPipelineBarrier2(commands, &info);
    images.clear();
    buffers.clear();
}

void barrier(VkCommandBuffer commands, const VkMemoryBarrier2& memory) {
    const VkDependencyInfo info{
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &memory};
    vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace lightwalk
