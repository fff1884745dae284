// Uploads and read-backs within a frame.
#include "common/base/error.h"
#include "common/gpu/frame.h"

namespace lightwalk {

VkDescriptorBufferInfo Frame::copy_to_arena(std::span<const std::byte> bytes) {
    const VkPhysicalDeviceLimits& limits = gpu.device.properties.limits;
    if (bytes.size() > limits.maxUniformBufferRange)
        throw Failure("a uniform block has at most {} bytes", limits.maxUniformBufferRange);
    return recording().uniforms.copy(bytes, 256);  // enough on every device (the limit minUniformBufferOffsetAlignment)
}

void Frame::upload(const std::string& name, Buffer& buffer, std::span<const std::byte> bytes) {
    const VkDeviceSize needed = std::max<VkDeviceSize>(bytes.size(), 16);
    // Growth by half avoids recreating a slowly growing buffer every frame.
    if (buffer.capacity < needed)
        buffer = Buffer(gpu.device, {.name = name, .bytes = std::max(needed, buffer.capacity + buffer.capacity / 2)});
    buffer.bytes = needed;
    buffer.stride = 0;
    buffer.constant = true;
    make_room();
    const VkDescriptorBufferInfo from = recording().uploads.copy(bytes, 16);
    gpu.uploaded_bytes += bytes.size();
    transfer(name, {.reads = {}, .writes = {buffer}}, [&](VkCommandBuffer commands) {
        const VkBufferCopy region{.srcOffset = from.offset, .size = bytes.size()};
        if (!bytes.empty()) vkCmdCopyBuffer(commands, from.buffer, buffer.handle, 1, &region);
    });
}

void Frame::upload(const std::string& name, const Buffer& buffer, std::span<const std::byte> bytes,
                   std::span<const VkBufferCopy> parts) {
    make_room();
    const VkDescriptorBufferInfo from = recording().uploads.copy(bytes, 16);
    gpu.uploaded_bytes += bytes.size();
    transfer(name, {.reads = {}, .writes = {buffer}}, [&](VkCommandBuffer commands) {
        for (VkBufferCopy part : parts) {
            part.srcOffset += from.offset;
            vkCmdCopyBuffer(commands, from.buffer, buffer.handle, 1, &part);
        }
    });
}

void Frame::upload(const std::string& name, const ImageView& view, std::span<const std::byte> texels) {
    if (texels.size() != byte_count(view))
        throw Failure("upload of {} bytes into {}, which holds {}", texels.size(), view.name(), byte_count(view));
    make_room();
    const VkDescriptorBufferInfo from = recording().uploads.copy(texels, 4 * texel_bytes(view.image->desc.format));
    gpu.uploaded_bytes += texels.size();
    transfer(name, {.reads = {}, .writes = {view.mip(0)}}, [&](VkCommandBuffer commands) {
        const VkBufferImageCopy region = region_of(from.offset, view);
        vkCmdCopyBufferToImage(commands, from.buffer, view.image->handle, transfer_write.layout, 1, &region);
    });
}

void Frame::copy_images(const std::string& name, const std::vector<std::pair<ImageView, ImageView>>& views) {
    ComputeAccess access;
    for (const auto& [from, into] : views) {
        if (from.image->desc.format != into.image->desc.format || from.size() != into.size() ||
            from.mips != into.mips || from.layers != into.layers)
            throw Failure("{}: {} and {} differ in format, size, mips or layers", name, from.name(), into.name());
        access.reads.push_back(from);
        access.writes.push_back(into);
    }
    transfer(name, access, [&](VkCommandBuffer commands) {
        for (const auto& [from, into] : views) {
            for (uint32_t mip = 0; mip < from.mips; ++mip) {
                const glm::uvec3 texels = from.mip(mip).size();
                const VkImageCopy region{.srcSubresource = from.mip(mip).first_mip_layers(),
                                         .dstSubresource = into.mip(mip).first_mip_layers(),
                                         .extent = {texels.x, texels.y, texels.z}};
                vkCmdCopyImage(commands, from.image->handle, transfer_read.layout, into.image->handle,
                               transfer_write.layout, 1, &region);
            }
        }
    });
}

void Frame::fill(const std::string& name, const Image& image, glm::vec4 value) {
    transfer(name, {.reads = {}, .writes = {image}}, [&](VkCommandBuffer commands) {
        const VkClearColorValue color{.float32 = {value.r, value.g, value.b, value.a}};
        const VkImageSubresourceRange whole = ImageView(image).range();
        vkCmdClearColorImage(commands, image.handle, transfer_write.layout, &color, 1, &whole);
    });
}

// Double buffering: contents of the last ended frame stay valid until this frame ends.
const Buffer& Frame::staging_for(ReadBack& into, const std::string& name, VkDeviceSize bytes) {
    if (!into.state_) into.state_ = std::make_shared<ReadBack::State>();
    Buffer staging = std::move(into.state_->spare);
    if (staging.capacity < bytes)
        staging = Buffer(gpu.device, {.name = "read back " + name, .bytes = bytes, .host_visible = true});
    recording().read_backs.push_back({into.state_, std::move(staging), bytes});
    return recording().read_backs.back().staging;
}

void Frame::read_back(const Buffer& buffer, ReadBack& into) {
    const Buffer& staging = staging_for(into, buffer.name, buffer.bytes);
    transfer("read back " + buffer.name, {.reads = {buffer}, .writes = {staging}}, [&](VkCommandBuffer commands) {
        const VkBufferCopy region{.size = buffer.bytes};
        vkCmdCopyBuffer(commands, buffer.handle, staging.handle, 1, &region);
        barrier(commands, staging, host_read);
    });
}

void Frame::read_back(const ImageView& view, ReadBack& into) {
    if (view.image->desc.samples > 1) throw Failure("{} has several samples: resolve it, then read back", view.name());
    const Buffer& staging = staging_for(into, view.name(), byte_count(view));
    transfer("read back " + view.name(), {.reads = {view.mip(0)}, .writes = {staging}}, [&](VkCommandBuffer commands) {
        const VkBufferImageCopy region = region_of(0, view);
        vkCmdCopyImageToBuffer(commands, view.image->handle, transfer_read.layout, staging.handle, 1, &region);
        barrier(commands, staging, host_read);
    });
}

}  // namespace lightwalk
