// Blocking uploads and read-backs.
#include <cstring>

#include "common/base/error.h"
#include "common/base/shared_lock.h"
#include "common/gpu/barrier.h"
#include "common/gpu/gpu.h"

namespace lightwalk {
namespace {

void fill(const Buffer& staging, size_t at, std::span<const std::byte> bytes) {
    unlocked([&] { std::memcpy(staging.mapped + at, bytes.data(), bytes.size()); });
}

std::vector<std::byte> contents(const Buffer& staging, VkDeviceSize bytes) {
    return unlocked([&] { return std::vector<std::byte>(staging.mapped, staging.mapped + bytes); });
}

void check_size(const ImageView& view, VkDeviceSize bytes) {
    if (bytes != byte_count(view))
        throw Failure("upload of {} bytes into {}, which holds {}", bytes, view.name(), byte_count(view));
}

}  // namespace

VkBufferImageCopy region_of(VkDeviceSize offset, const ImageView& view) {
    const glm::uvec3 size = view.size();
    return {
        .bufferOffset = offset, .imageSubresource = view.first_mip_layers(), .imageExtent = {size.x, size.y, size.z}};
}

void copy(VkCommandBuffer commands, VkBuffer from, VkDeviceSize offset, const ImageView& to) {
    const VkBufferImageCopy one = region_of(offset, to);
    vkCmdCopyBufferToImage(commands, from, to.image->handle, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &one);
}

void copy(VkCommandBuffer commands, const ImageView& from, VkBuffer to) {
    const VkBufferImageCopy one = region_of(0, from);
    vkCmdCopyImageToBuffer(commands, from.image->handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to, 1, &one);
}

Buffer Gpu::upload(const std::string& name, std::span<const std::byte> bytes) {
    Buffer buffer(device, {.name = name, .bytes = bytes.size()});
    if (!bytes.empty()) {
        Buffer staging(device, {.name = name + " staging", .bytes = bytes.size(), .host_visible = true});
        fill(staging, 0, bytes);
        submit_now([&](VkCommandBuffer commands) {
            const VkBufferCopy region{.size = bytes.size()};
            barrier(commands, buffer, transfer_write);
            vkCmdCopyBuffer(commands, staging.handle, buffer.handle, 1, &region);
            barrier(commands, buffer, any_read);
        });
        uploaded_bytes += bytes.size();
    }
    buffer.constant = true;
    return buffer;
}

void Gpu::upload(Image& image, std::span<const std::byte> texels) {
    const ImageView whole(image);
    check_size(whole, texels.size());
    if (image.desc.mips > 1) throw Failure("upload of one level into {}, which has {}", whole.name(), image.desc.mips);
    Buffer staging(device, {.name = image.desc.name + " staging", .bytes = texels.size(), .host_visible = true});
    fill(staging, 0, texels);
    uploaded_bytes += texels.size();
    submit_now([&](VkCommandBuffer commands) {
        barrier(commands, whole, transfer_write);
        copy(commands, staging.handle, 0, whole.mip(0));
        barrier(commands, whole, any_read);
    });
    image.constant = true;
}

void Gpu::upload(Image& image, const std::vector<std::vector<std::byte>>& levels) {
    const ImageView whole(image);
    VkDeviceSize bytes = 0;
    for (const auto& level : levels) bytes += level.size();
    Buffer staging(device, {.name = image.desc.name + " staging", .bytes = bytes, .host_visible = true});
    std::vector<VkDeviceSize> offsets;
    VkDeviceSize at = 0;
    for (uint32_t m = 0; m < image.desc.mips; ++m) {
        const auto& level = levels.at(m);
        check_size(whole.mip(m), level.size());
        fill(staging, at, level);
        offsets.push_back(at);
        at += level.size();
    }
    uploaded_bytes += bytes;
    submit_now([&](VkCommandBuffer commands) {
        barrier(commands, whole, transfer_write);
        for (uint32_t m = 0; m < image.desc.mips; ++m) copy(commands, staging.handle, offsets[m], whole.mip(m));
        barrier(commands, whole, any_read);
    });
    image.constant = true;
}

std::vector<std::byte> Gpu::read_back(const ImageView& view) {
    if (view.image->desc.samples > 1) throw Failure("{} has several samples: resolve it, then read back", view.name());
    const VkDeviceSize bytes = byte_count(view);
    Buffer staging(device, {.name = "read back " + view.name(), .bytes = bytes, .host_visible = true});
    submit_now([&](VkCommandBuffer commands) {
        barrier(commands, view.mip(0), transfer_read);
        barrier(commands, staging, transfer_write);
        copy(commands, view, staging.handle);
        if (view.image->constant) barrier(commands, view.mip(0), any_read);
        barrier(commands, staging, host_read);
    });
    return contents(staging, bytes);
}

std::vector<std::byte> Gpu::read_back(const Buffer& buffer) {
    Buffer staging(device, {.name = "read back " + buffer.name, .bytes = buffer.bytes, .host_visible = true});
    submit_now([&](VkCommandBuffer commands) {
        barrier(commands, buffer, transfer_read);
        const VkBufferCopy region{.size = buffer.bytes};
        barrier(commands, staging, transfer_write);
        vkCmdCopyBuffer(commands, buffer.handle, staging.handle, 1, &region);
        barrier(commands, staging, host_read);
    });
    return contents(staging, buffer.bytes);
}

}  // namespace lightwalk
