#include "common/gpu/commands.h"

#include <bit>
#include <type_traits>

#include "common/gpu/command_codes.h"
#include "common/gpu/device.h"

namespace lightwalk {

using Code = CommandCode;

namespace {

template <class T>
uint64_t word(T value) {
    if constexpr (std::is_pointer_v<T>)
        return reinterpret_cast<uint64_t>(value);
    else if constexpr (std::is_same_v<T, float>)
        return std::bit_cast<uint32_t>(value);
    else
        return static_cast<uint64_t>(value);
}

// Structures are written member by member: bytes between their members may be anything.
template <class... Values>
void put(CommandWords& words, Values... values) {
    uint64_t* at = words.take(sizeof...(values));
    ((*at++ = word(values)), ...);
}

void put(CommandWords& words, const VkImageSubresourceLayers& l) {
    put(words, l.aspectMask, l.mipLevel, l.baseArrayLayer, l.layerCount);
}

void put(CommandWords& words, const VkBufferImageCopy& r) {
    put(words, r.bufferOffset);
    put(words, r.imageSubresource);
    put(words, r.imageOffset.x, r.imageOffset.y, r.imageOffset.z);
    put(words, r.imageExtent.width, r.imageExtent.height, r.imageExtent.depth);
}

void put(CommandWords& words, const VkRenderingAttachmentInfo& a, bool is_depth) {
    const auto& color = a.clearValue.color.uint32;
    put(words, a.imageView, a.imageLayout, a.resolveMode, a.resolveImageView, a.resolveImageLayout, a.loadOp,
        a.storeOp);
    if (is_depth)
        put(words, a.clearValue.depthStencil.depth);
    else
        put(words, color[0], color[1], color[2], color[3]);
}

}  // namespace

uint64_t* CommandWords::take(size_t count) {
    if (used_ + count > words_.size()) words_.resize(2 * words_.size() + count);
    used_ += count;
    return words_.data() + used_ - count;
}

void Commands::pipeline_barrier(std::span<const VkImageMemoryBarrier2> images,
                                std::span<const VkBufferMemoryBarrier2> buffers) {
    put(words_, Code::pipeline_barrier, images.size(), buffers.size());
    for (const VkImageMemoryBarrier2& b : images) {
        const VkImageSubresourceRange& part = b.subresourceRange;
        put(words_, b.srcStageMask, b.srcAccessMask, b.dstStageMask, b.dstAccessMask, b.oldLayout, b.newLayout, b.image,
            part.aspectMask, part.baseMipLevel, part.levelCount, part.baseArrayLayer, part.layerCount);
    }
    for (const VkBufferMemoryBarrier2& b : buffers)
        put(words_, b.srcStageMask, b.srcAccessMask, b.dstStageMask, b.dstAccessMask, b.buffer);
}

void Commands::pipeline_barrier(const VkMemoryBarrier2& memory) {
    put(words_, Code::memory_barrier, memory.srcStageMask, memory.srcAccessMask, memory.dstStageMask,
        memory.dstAccessMask);
}

void Commands::wait_for_all() { put(words_, Code::wait_for_all); }

void Commands::set_event(VkEvent event) { put(words_, Code::set_event, event); }

void Commands::write_timestamp(VkQueryPool pool, uint32_t query) {
    put(words_, Code::write_timestamp, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool, query);
}

// Its length, then eight characters a number.
void Commands::begin_label(const Device& device, const std::string& name) {
    if (!device.has_labels()) return;
    put(words_, Code::begin_label, name.size());
    for (size_t at = 0; at < name.size(); at += 8) {
        uint64_t part = 0;
        name.copy(reinterpret_cast<char*>(&part), 8, at);
        put(words_, part);
    }
}

void Commands::end_label(const Device& device) {
    if (device.has_labels()) put(words_, Code::end_label);
}

void Commands::push_descriptors(VkPipelineBindPoint point, VkPipelineLayout layout,
                                std::span<const VkWriteDescriptorSet> writes) {
    put(words_, Code::push_descriptors, point, layout, writes.size());
    for (const VkWriteDescriptorSet& write : writes) {
        put(words_, write.dstBinding, write.descriptorType, write.descriptorCount);
        for (uint32_t i = 0; i < write.descriptorCount; ++i)
            if (of_buffer(write.descriptorType))
                put(words_, write.pBufferInfo[i].buffer, write.pBufferInfo[i].offset, write.pBufferInfo[i].range);
            else
                put(words_, write.pImageInfo[i].sampler, write.pImageInfo[i].imageView,
                    write.pImageInfo[i].imageLayout);
    }
}

void Commands::begin_rendering(const VkRenderingInfo& info) {
    put(words_, Code::begin_rendering, info.renderArea.extent.width, info.renderArea.extent.height, info.layerCount,
        info.pDepthAttachment ? 1 : 0, info.colorAttachmentCount);
    for (uint32_t i = 0; i < info.colorAttachmentCount; ++i) put(words_, info.pColorAttachments[i], false);
    if (info.pDepthAttachment) put(words_, *info.pDepthAttachment, true);
}

void Commands::bind_pipeline(VkPipelineBindPoint point, VkPipeline pipeline) {
    put(words_, Code::bind_pipeline, point, pipeline);
}

void Commands::push_constant(VkPipelineLayout layout, VkShaderStageFlags stages, uint32_t value) {
    put(words_, Code::push_constant, layout, stages, value);
}

void Commands::bind_descriptor_set(VkPipelineBindPoint point, VkPipelineLayout layout, VkDescriptorSet set) {
    put(words_, Code::bind_descriptor_set, point, layout, set);
}

void Commands::end_rendering() { put(words_, Code::end_rendering); }

void Commands::set_viewport(uint32_t width, uint32_t height) { put(words_, Code::set_viewport, width, height); }

void Commands::set_front_face(VkFrontFace face) { put(words_, Code::set_front_face, face); }

void Commands::set_cull_mode(VkCullModeFlags mode) { put(words_, Code::set_cull_mode, mode); }

void Commands::bind_index_buffer(VkBuffer buffer) {
    put(words_, Code::bind_index_buffer, buffer, 0, VK_INDEX_TYPE_UINT32);
}

void Commands::draw(uint32_t vertices, uint32_t instances, uint32_t first_instance) {
    put(words_, Code::draw, vertices, instances, 0, first_instance);
}

void Commands::draw_indexed(uint32_t count, uint32_t instances, uint32_t first_index, uint32_t first_instance) {
    put(words_, Code::draw_indexed, count, instances, first_index, 0, first_instance);
}

void Commands::draw_indirect(VkBuffer buffer, VkDeviceSize offset, uint32_t count, uint32_t stride) {
    put(words_, Code::draw_indirect, buffer, offset, count, stride);
}

void Commands::draw_indexed_indirect(VkBuffer buffer, VkDeviceSize offset, uint32_t count, uint32_t stride) {
    put(words_, Code::draw_indexed_indirect, buffer, offset, count, stride);
}

void Commands::dispatch(glm::uvec3 groups) { put(words_, Code::dispatch, groups.x, groups.y, groups.z); }

void Commands::dispatch_indirect(VkBuffer buffer, VkDeviceSize offset) {
    put(words_, Code::dispatch_indirect, buffer, offset);
}

void Commands::copy_buffer(VkBuffer from, VkBuffer to, const VkBufferCopy& region) {
    put(words_, Code::copy_buffer, from, to, region.srcOffset, region.dstOffset, region.size);
}

void Commands::copy_buffer_to_image(VkBuffer from, VkImage to, const VkBufferImageCopy& region) {
    put(words_, Code::copy_buffer_to_image, from, to);
    put(words_, region);
}

void Commands::copy_image_to_buffer(VkImage from, VkBuffer to, const VkBufferImageCopy& region) {
    put(words_, Code::copy_image_to_buffer, from, to);
    put(words_, region);
}

void Commands::copy_image(VkImage from, VkImage to, const VkImageCopy& region) {
    put(words_, Code::copy_image, from, to);
    put(words_, region.srcSubresource);
    put(words_, region.dstSubresource);
    put(words_, region.extent.width, region.extent.height, region.extent.depth);
}

void Commands::clear_color_image(VkImage image, const VkClearColorValue& color) {
    put(words_, Code::clear_color_image, image, color.uint32[0], color.uint32[1], color.uint32[2], color.uint32[3]);
}

void Commands::update_buffer(VkBuffer buffer, std::span<const uint32_t> contents) {
    put(words_, Code::update_buffer, buffer, contents.size());
    for (const uint32_t number : contents) put(words_, number);
}

}  // namespace lightwalk
