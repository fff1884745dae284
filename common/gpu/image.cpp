#include "common/gpu/image.h"

#include <bit>
#include <utility>

#include "common/base/error.h"

namespace lightwalk {
namespace {

VkImageUsageFlags usage_of(const Device& device, const Image& image) {
    VkFormatProperties supported;
    vkGetPhysicalDeviceFormatProperties(device.physical, image.desc.format, &supported);
    const VkFormatFeatureFlags has = supported.optimalTilingFeatures;
    VkImageUsageFlags usage =
        VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    // Multisampled storage images need another feature; an H200 (driver 580) misrenders depth written by compute.
    if (has & VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT && image.desc.samples == 1 && !image.is_depth())
        usage |= VK_IMAGE_USAGE_STORAGE_BIT;
    // sRGB images are written through codes(), as 8-bit storage images, which every device supports.
    if (image.desc.format == VK_FORMAT_R8G8B8A8_SRGB && image.desc.samples == 1) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
    if (has & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT) usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    if (image.is_depth()) usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    return usage;
}

void check_supported(const Device& device, const VkImageCreateInfo& info, const std::string& name) {
    const auto fail = [&](const std::string& why) { throw Failure("image {}: {}", name, why); };
    VkImageFormatProperties most;
    if (vkGetPhysicalDeviceImageFormatProperties(device.physical, info.format, info.imageType, info.tiling, info.usage,
                                                 info.flags, &most) != VK_SUCCESS)
        fail("the device has no images of " + name_of(info.format));
    const VkDeviceSize bytes = VkDeviceSize(info.extent.width) * info.extent.height * info.extent.depth *
                               info.arrayLayers * info.samples * texel_bytes(info.format);
    if (!(most.sampleCounts & info.samples)) fail(fmt::format("the device has no {} samples", int(info.samples)));
    if (info.extent.width > most.maxExtent.width || info.extent.height > most.maxExtent.height ||
        info.extent.depth > most.maxExtent.depth || info.mipLevels > most.maxMipLevels ||
        info.arrayLayers > most.maxArrayLayers)
        fail(fmt::format("the device has at most {}×{}×{} texels, {} mips and {} layers", most.maxExtent.width,
                         most.maxExtent.height, most.maxExtent.depth, most.maxMipLevels, most.maxArrayLayers));
    if (bytes > most.maxResourceSize)
        fail(fmt::format("{} MiB, and the device's have at most {}", bytes >> 20, most.maxResourceSize >> 20));
}

}  // namespace

Image::Image(Device& device, const Desc& wanted) : Image() {
    device_ = &device;
    desc = wanted;
    if (desc.cube && desc.layers == 1) desc.layers = 6;
    if ((desc.depth && (desc.layers > 1 || desc.cube)) || (desc.cube && desc.layers % 6))
        throw Failure("image {}: a volume has one layer, a cube a multiple of 6", desc.name);
    VkImageCreateFlags flags = 0;
    if (desc.cube) flags |= VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
    if (desc.depth) flags |= VK_IMAGE_CREATE_2D_ARRAY_COMPATIBLE_BIT;
    usage_ = usage_of(device, *this);
    writes_codes_ = desc.format == VK_FORMAT_R8G8B8A8_SRGB && usage_ & VK_IMAGE_USAGE_STORAGE_BIT;
    if (writes_codes_) flags |= VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT | VK_IMAGE_CREATE_EXTENDED_USAGE_BIT;
    constexpr VkFormat both[]{VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_R8G8B8A8_UNORM};
    const VkImageFormatListCreateInfo formats{
        .sType = VK_STRUCTURE_TYPE_IMAGE_FORMAT_LIST_CREATE_INFO, .viewFormatCount = 2, .pViewFormats = both};
    const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                 .pNext = writes_codes_ ? &formats : nullptr,
                                 .flags = flags,
                                 .imageType = desc.depth ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D,
                                 .format = desc.format,
                                 .extent = {desc.size.x, desc.size.y, std::max(desc.depth, 1u)},
                                 .mipLevels = desc.mips,
                                 .arrayLayers = desc.layers,
                                 .samples = static_cast<VkSampleCountFlagBits>(desc.samples),
                                 .usage = usage_};
    check_supported(device, info, desc.name);
    check(vkCreateImage(device.handle, &info, nullptr, &handle), ("image " + desc.name).c_str());
    device.set_name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(handle), desc.name);
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device.handle, handle, &needs);
    memory_ = device.allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, "image " + desc.name);
    check(vkBindImageMemory(device.handle, handle, memory_, 0), "vkBindImageMemory");
}

Image Image::borrowed(Device& device, VkImage handle, const Desc& desc) {
    Image image;
    image.device_ = &device;
    image.owned_ = false;
    image.handle = handle;
    image.desc = desc;
    device.set_name(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(handle), desc.name);
    return image;
}

bool Image::ensure(Device& device, const Desc& wanted) {
    if (handle && desc == wanted) return false;
    *this = Image(device, wanted);
    return true;
}

Image::~Image() {
    if (!device_) return;
    Retired objects{.memory = memory_};
    if (owned_) objects.image = handle;
    for (const auto& [view, made] : views_) objects.views.push_back(made);
    device_->destroy(std::move(objects));
}

void Image::swap(Image& other) noexcept {
    std::swap(handle, other.handle);
    std::swap(desc, other.desc);
    std::swap(history, other.history);
    std::swap(constant, other.constant);
    std::swap(written_in, other.written_in);
    std::swap(shown_in, other.shown_in);
    std::swap(device_, other.device_);
    std::swap(owned_, other.owned_);
    std::swap(usage_, other.usage_);
    std::swap(writes_codes_, other.writes_codes_);
    std::swap(memory_, other.memory_);
    std::swap(views_, other.views_);
    for (auto& [view, made] : views_) view.image = this;
    for (auto& [view, made] : other.views_) view.image = &other;
}

uint32_t full_mip_count(glm::uvec2 size) { return static_cast<uint32_t>(std::bit_width(std::max(size.x, size.y))); }

}  // namespace lightwalk
