// The replay of a list of commands into a command buffer.
#include <algorithm>
#include <bit>
#include <tuple>
#include <type_traits>

#include "common/gpu/command_codes.h"
#include "common/gpu/commands.h"
#include "common/gpu/device.h"

namespace lightwalk {
namespace {

/// Takes numbers in the order in which they were put.
class Reader {
  public:
    explicit Reader(std::span<const uint64_t> words) : at_(words.data()), end_(at_ + words.size()) {}
    explicit operator bool() const { return at_ != end_; }

    template <class T>
    void take(T& value) {
        const uint64_t number = *at_++;
        if constexpr (std::is_pointer_v<T>)
            value = reinterpret_cast<T>(number);
        else if constexpr (std::is_same_v<T, float>)
            value = std::bit_cast<float>(static_cast<uint32_t>(number));
        else
            value = static_cast<T>(number);
    }
    template <class T>
    T take() {
        T value;
        take(value);
        return value;
    }
    template <class... Values>
    void take_all(Values&... values) {
        (take(values), ...);
    }
    void take(VkImageSubresourceLayers& l) { take_all(l.aspectMask, l.mipLevel, l.baseArrayLayer, l.layerCount); }
    void take(VkBufferImageCopy& r) {
        take_all(r.bufferOffset, r.imageSubresource, r.imageOffset.x, r.imageOffset.y, r.imageOffset.z,
                 r.imageExtent.width, r.imageExtent.height, r.imageExtent.depth);
    }
    /// Arguments of a command that takes nothing else, in their order: the call's, too.
    template <class... Arguments>
    void call(VkCommandBuffer into, void (*command)(VkCommandBuffer, Arguments...)) {
        std::tuple<Arguments...> arguments;
        std::apply([&](Arguments&... one) { (take(one), ...); }, arguments);
        std::apply([&](Arguments... one) { command(into, one...); }, arguments);
    }

  private:
    const uint64_t *at_, *end_;
};

/// Replays one list into one command buffer; arrays are kept from command to command.
struct Replay {
    const Device& device;
    VkCommandBuffer into;
    Reader reader;
    std::vector<VkImageMemoryBarrier2> images;
    std::vector<VkBufferMemoryBarrier2> buffers;
    std::vector<VkRenderingAttachmentInfo> targets;
    std::vector<VkWriteDescriptorSet> writes;
    std::vector<VkDescriptorImageInfo> image_infos;
    std::vector<VkDescriptorBufferInfo> buffer_infos;
    std::vector<uint32_t> contents;

    void run(CommandCode code);
    void barrier(const VkDependencyInfo& what) { vkCmdPipelineBarrier2(into, &what); }
    void barriers();
    void descriptors();
    void rendering();
    void label();
    void viewport();
    void transfer(CommandCode code);
};

VkDependencyInfo dependency(const VkMemoryBarrier2& memory) {
    return {.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &memory};
}

void Replay::barriers() {
    images.assign(reader.take<size_t>(), {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                          .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                          .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED});
    buffers.assign(reader.take<size_t>(), {.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2,
                                           .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                           .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                           .size = VK_WHOLE_SIZE});
    for (VkImageMemoryBarrier2& b : images) {
        VkImageSubresourceRange& part = b.subresourceRange;
        reader.take_all(b.srcStageMask, b.srcAccessMask, b.dstStageMask, b.dstAccessMask, b.oldLayout, b.newLayout,
                        b.image, part.aspectMask, part.baseMipLevel, part.levelCount, part.baseArrayLayer,
                        part.layerCount);
    }
    for (VkBufferMemoryBarrier2& b : buffers)
        reader.take_all(b.srcStageMask, b.srcAccessMask, b.dstStageMask, b.dstAccessMask, b.buffer);
    barrier({.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
             .bufferMemoryBarrierCount = static_cast<uint32_t>(buffers.size()),
             .pBufferMemoryBarriers = buffers.data(),
             .imageMemoryBarrierCount = static_cast<uint32_t>(images.size()),
             .pImageMemoryBarriers = images.data()});
}

void Replay::descriptors() {
    const auto point = reader.take<VkPipelineBindPoint>();
    const auto layout = reader.take<VkPipelineLayout>();
    writes.assign(reader.take<size_t>(), {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET});
    image_infos.clear();
    buffer_infos.clear();
    for (VkWriteDescriptorSet& write : writes) {
        reader.take_all(write.dstBinding, write.descriptorType, write.descriptorCount);
        for (uint32_t i = 0; i < write.descriptorCount; ++i)
            if (VkDescriptorBufferInfo buffer; of_buffer(write.descriptorType)) {
                reader.take_all(buffer.buffer, buffer.offset, buffer.range);
                buffer_infos.push_back(buffer);
            } else {
                VkDescriptorImageInfo image;
                reader.take_all(image.sampler, image.imageView, image.imageLayout);
                image_infos.push_back(image);
            }
    }
    size_t image = 0, buffer = 0;  // once the lists no longer grow
    for (VkWriteDescriptorSet& write : writes)
        if (of_buffer(write.descriptorType)) {
            write.pBufferInfo = &buffer_infos[buffer];
            buffer += write.descriptorCount;
        } else {
            write.pImageInfo = &image_infos[image];
            image += write.descriptorCount;
        }
    device.push_descriptors(into, point, layout, 0, static_cast<uint32_t>(writes.size()), writes.data());
}

void Replay::rendering() {
    VkRenderingInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO};
    reader.take_all(info.renderArea.extent.width, info.renderArea.extent.height, info.layerCount);
    const auto has_depth = reader.take<uint32_t>();
    reader.take(info.colorAttachmentCount);
    targets.assign(info.colorAttachmentCount + has_depth, {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO});
    for (VkRenderingAttachmentInfo& a : targets) {
        reader.take_all(a.imageView, a.imageLayout, a.resolveMode, a.resolveImageView, a.resolveImageLayout, a.loadOp,
                        a.storeOp);
        auto& color = a.clearValue.color.uint32;
        if (has_depth && &a == &targets.back())
            reader.take(a.clearValue.depthStencil.depth);
        else
            reader.take_all(color[0], color[1], color[2], color[3]);
    }
    info.pColorAttachments = targets.data();
    info.pDepthAttachment = has_depth ? &targets.back() : nullptr;
    vkCmdBeginRendering(into, &info);
}

void Replay::label() {
    std::string name(reader.take<size_t>(), ' ');
    for (size_t at = 0; at < name.size(); at += 8) {
        const auto part = reader.take<uint64_t>();
        name.replace(at, 8, reinterpret_cast<const char*>(&part), std::min<size_t>(8, name.size() - at));
    }
    device.begin_label(into, name.c_str());
}

void Replay::run(CommandCode code) {
    using enum CommandCode;
    switch (code) {
        case pipeline_barrier:
            return barriers();
        case memory_barrier: {
            VkMemoryBarrier2 memory{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
            reader.take_all(memory.srcStageMask, memory.srcAccessMask, memory.dstStageMask, memory.dstAccessMask);
            return barrier(dependency(memory));
        }
        case wait_for_all:
            return barrier({.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO});
        case set_event: {
            const VkMemoryBarrier2 all{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                                       .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                       .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
            const VkDependencyInfo before = dependency(all);
            return vkCmdSetEvent2(into, reader.take<VkEvent>(), &before);
        }
        case write_timestamp:
            return reader.call(into, vkCmdWriteTimestamp2);
        case begin_label:
            return label();
        case end_label:
            return device.end_label(into);
        case bind_pipeline:
            return reader.call(into, vkCmdBindPipeline);
        case push_constant: {
            const auto layout = reader.take<VkPipelineLayout>();
            const auto stages = reader.take<VkShaderStageFlags>();
            const auto value = reader.take<uint32_t>();
            return vkCmdPushConstants(into, layout, stages, 0, sizeof value, &value);
        }
        case push_descriptors:
            return descriptors();
        case bind_descriptor_set: {
            const auto point = reader.take<VkPipelineBindPoint>();
            const auto layout = reader.take<VkPipelineLayout>();
            const auto set = reader.take<VkDescriptorSet>();
            return vkCmdBindDescriptorSets(into, point, layout, 0, 1, &set, 0, nullptr);
        }
        case begin_rendering:
            return rendering();
        case end_rendering:
            return vkCmdEndRendering(into);
        case set_viewport:
            return viewport();
        case set_front_face:
            return reader.call(into, vkCmdSetFrontFace);
        case set_cull_mode:
            return reader.call(into, vkCmdSetCullMode);
        case bind_index_buffer:
            return reader.call(into, vkCmdBindIndexBuffer);
        case draw:
            return reader.call(into, vkCmdDraw);
        case draw_indexed:
            return reader.call(into, vkCmdDrawIndexed);
        case draw_indirect:
            return reader.call(into, vkCmdDrawIndirect);
        case draw_indexed_indirect:
            return reader.call(into, vkCmdDrawIndexedIndirect);
        case dispatch:
            return reader.call(into, vkCmdDispatch);
        case dispatch_indirect:
            return reader.call(into, vkCmdDispatchIndirect);
        default:
            return transfer(code);
    }
}

void Replay::viewport() {
    VkRect2D area{};
    reader.take_all(area.extent.width, area.extent.height);
    const VkViewport whole{.width = float(area.extent.width), .height = float(area.extent.height), .maxDepth = 1.0f};
    vkCmdSetViewport(into, 0, 1, &whole);
    vkCmdSetScissor(into, 0, 1, &area);
}

void Replay::transfer(CommandCode code) {
    using enum CommandCode;
    constexpr VkImageLayout source = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    constexpr VkImageLayout target = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    if (code == update_buffer) {
        const auto buffer = reader.take<VkBuffer>();
        contents.resize(reader.take<size_t>());
        for (uint32_t& number : contents) reader.take(number);
        return vkCmdUpdateBuffer(into, buffer, 0, 4 * contents.size(), contents.data());
    }
    if (code == clear_color_image) {
        const auto image = reader.take<VkImage>();
        VkClearColorValue color;
        reader.take_all(color.uint32[0], color.uint32[1], color.uint32[2], color.uint32[3]);
        const VkImageSubresourceRange whole{.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT,
                                            .levelCount = VK_REMAINING_MIP_LEVELS,
                                            .layerCount = VK_REMAINING_ARRAY_LAYERS};
        return vkCmdClearColorImage(into, image, target, &color, 1, &whole);
    }
    const auto from = reader.take<uint64_t>(), to = reader.take<uint64_t>();
    const auto buffer = [](uint64_t handle) { return reinterpret_cast<VkBuffer>(handle); };
    const auto image = [](uint64_t handle) { return reinterpret_cast<VkImage>(handle); };
    VkBufferCopy bytes{};
    VkBufferImageCopy both{};
    VkImageCopy texels{};
    switch (code) {
        case copy_buffer:
            reader.take_all(bytes.srcOffset, bytes.dstOffset, bytes.size);
            return vkCmdCopyBuffer(into, buffer(from), buffer(to), 1, &bytes);
        case copy_buffer_to_image:
            reader.take(both);
            return vkCmdCopyBufferToImage(into, buffer(from), image(to), target, 1, &both);
        case copy_image_to_buffer:
            reader.take(both);
            return vkCmdCopyImageToBuffer(into, image(from), source, buffer(to), 1, &both);
        default:  // copy_image
            reader.take(texels.srcSubresource);
            reader.take(texels.dstSubresource);
            reader.take_all(texels.extent.width, texels.extent.height, texels.extent.depth);
            return vkCmdCopyImage(into, image(from), source, image(to), target, 1, &texels);
    }
}

}  // namespace

void Commands::record(const Device& device, VkCommandBuffer into) const {
    Replay replay{.device = device, .into = into, .reader = Reader(words_.all())};
    while (replay.reader) replay.run(replay.reader.take<CommandCode>());
}

}  // namespace lightwalk
