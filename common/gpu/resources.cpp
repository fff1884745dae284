#include "common/gpu/resources.h"

#include <bit>

#include "common/base/error.h"

namespace lightwalk {
namespace {

VkDeviceMemory allocate(Device& device, const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties,
                        const std::string& name) {
    const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                    .allocationSize = needs.size,
                                    .memoryTypeIndex = device.memory_type(needs.memoryTypeBits, properties)};
    VkDeviceMemory memory = VK_NULL_HANDLE;
    check(vkAllocateMemory(device.handle, &info, nullptr, &memory), ("memory of " + name).c_str());
    return memory;
}

}  // namespace

Buffer::Buffer(Device& device, const Desc& desc) : bytes(std::max<VkDeviceSize>(desc.bytes, 16)), name(desc.name) {
    device_ = &device;
    const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                  .size = bytes,
                                  .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                                           VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                                           VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT};
    check(vkCreateBuffer(device.handle, &info, nullptr, &handle), ("buffer " + name).c_str());
    device.set_name(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<uint64_t>(handle), name);
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device.handle, handle, &needs);
    memory_ = allocate(device, needs,
                       desc.host_visible ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT
                                         : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT,
                       name);
    check(vkBindBufferMemory(device.handle, handle, memory_, 0), "vkBindBufferMemory");
    if (desc.host_visible) {
        void* address = nullptr;
        check(vkMapMemory(device.handle, memory_, 0, VK_WHOLE_SIZE, 0, &address), "vkMapMemory");
        mapped = static_cast<std::byte*>(address);
    }
}

Buffer::~Buffer() {
    if (!device_) return;
    vkDestroyBuffer(device_->handle, handle, nullptr);
    vkFreeMemory(device_->handle, memory_, nullptr);
}

void Buffer::swap(Buffer& other) noexcept {
    std::swap(handle, other.handle);
    std::swap(bytes, other.bytes);
    std::swap(mapped, other.mapped);
    std::swap(name, other.name);
    std::swap(history, other.history);
    std::swap(constant, other.constant);
    std::swap(device_, other.device_);
    std::swap(memory_, other.memory_);
}

Image::Image(Device& device, const Desc& wanted) : desc(wanted) {
    device_ = &device;
    VkImageUsageFlags usage =
        VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    VkFormatProperties supported;
    vkGetPhysicalDeviceFormatProperties(device.physical, desc.format, &supported);
    const VkFormatFeatureFlags has = supported.optimalTilingFeatures;
    if (has & VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
    if (has & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT) usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    if (is_depth()) usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                 .flags = desc.cube ? VkImageCreateFlags(VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT) : 0,
                                 .imageType = VK_IMAGE_TYPE_2D,
                                 .format = desc.format,
                                 .extent = {desc.size.x, desc.size.y, 1},
                                 .mipLevels = desc.mips,
                                 .arrayLayers = desc.layers,
                                 .samples = VK_SAMPLE_COUNT_1_BIT,
                                 .usage = usage};
    check(vkCreateImage(device.handle, &info, nullptr, &handle), ("image " + desc.name).c_str());
    device.set_name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(handle), desc.name);
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device.handle, handle, &needs);
    memory_ = allocate(device, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, desc.name);
    check(vkBindImageMemory(device.handle, handle, memory_, 0), "vkBindImageMemory");
    const VkImageViewCreateInfo view_info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                          .image = handle,
                                          .viewType = desc.cube         ? VK_IMAGE_VIEW_TYPE_CUBE
                                                      : desc.layers > 1 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY
                                                                        : VK_IMAGE_VIEW_TYPE_2D,
                                          .format = desc.format,
                                          .subresourceRange = range()};
    check(vkCreateImageView(device.handle, &view_info, nullptr, &view), ("view of " + desc.name).c_str());
}

VkImageSubresourceRange Image::range() const {
    return {.aspectMask = VkImageAspectFlags(is_depth() ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT),
            .levelCount = desc.mips,
            .layerCount = desc.layers};
}

VkImageView Image::mip_view(uint32_t mip) const {
    mip_views_.resize(desc.mips, VK_NULL_HANDLE);
    if (mip_views_.at(mip)) return mip_views_[mip];
    VkImageViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                               .image = handle,
                               .viewType = desc.layers > 1 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D,
                               .format = desc.format,
                               .subresourceRange = range()};
    info.subresourceRange.baseMipLevel = mip;
    info.subresourceRange.levelCount = 1;
    check(vkCreateImageView(device_->handle, &info, nullptr, &mip_views_[mip]), ("view of " + desc.name).c_str());
    return mip_views_[mip];
}

Image::~Image() {
    if (!device_) return;
    for (const VkImageView mip : mip_views_) vkDestroyImageView(device_->handle, mip, nullptr);
    vkDestroyImageView(device_->handle, view, nullptr);
    vkDestroyImage(device_->handle, handle, nullptr);
    vkFreeMemory(device_->handle, memory_, nullptr);
}

void Image::swap(Image& other) noexcept {
    std::swap(handle, other.handle);
    std::swap(view, other.view);
    std::swap(desc, other.desc);
    std::swap(history, other.history);
    std::swap(constant, other.constant);
    std::swap(device_, other.device_);
    std::swap(memory_, other.memory_);
    std::swap(mip_views_, other.mip_views_);
}

uint32_t texel_bytes(VkFormat format) {
    switch (format) {
        case VK_FORMAT_R8_UNORM:
            return 1;
        case VK_FORMAT_R16_UNORM:
        case VK_FORMAT_D16_UNORM:
        case VK_FORMAT_R16_SFLOAT:
            return 2;
        case VK_FORMAT_R8G8B8A8_UNORM:
        case VK_FORMAT_R8G8B8A8_SRGB:
        case VK_FORMAT_B8G8R8A8_UNORM:
        case VK_FORMAT_R16G16_SFLOAT:
        case VK_FORMAT_R32_UINT:
        case VK_FORMAT_D32_SFLOAT:
        case VK_FORMAT_R32_SFLOAT:
            return 4;
        case VK_FORMAT_R16G16B16A16_UNORM:
        case VK_FORMAT_R16G16B16A16_SFLOAT:
            return 8;
        case VK_FORMAT_R32G32B32A32_SFLOAT:
            return 16;
        default:
            throw Failure("texel_bytes: format " + std::to_string(format) + " is not in the table");
    }
}

uint32_t full_mip_count(glm::uvec2 size) { return static_cast<uint32_t>(std::bit_width(std::max(size.x, size.y))); }

Samplers::Samplers(Device& device) : device_(device) {
    for (const auto& [filter, address] : {std::pair{VK_FILTER_LINEAR, VK_SAMPLER_ADDRESS_MODE_REPEAT},
                                          std::pair{VK_FILTER_LINEAR, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE},
                                          std::pair{VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE},
                                          std::pair{VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_REPEAT}}) {
        const VkSamplerCreateInfo info{
            .sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
            .magFilter = filter,
            .minFilter = filter,
            .mipmapMode = filter == VK_FILTER_LINEAR ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST,
            .addressModeU = address,
            .addressModeV = address,
            .addressModeW = address,
            .maxLod = VK_LOD_CLAMP_NONE};
        check(vkCreateSampler(device.handle, &info, nullptr, &samplers_.emplace_back()), "vkCreateSampler");
    }
}

Samplers::~Samplers() {
    for (const VkSampler sampler : samplers_) vkDestroySampler(device_.handle, sampler, nullptr);
}

}  // namespace lightwalk
