#include <algorithm>

#include "common/base/error.h"
#include "common/gpu/image.h"

namespace lightwalk {
namespace {

VkImageViewType array_type(uint32_t layers) { return layers > 1 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D; }

bool meet(uint32_t a, uint32_t a_count, uint32_t b, uint32_t b_count) { return a < b + b_count && b < a + a_count; }

}  // namespace

ImageView::ImageView(const Image& whole)
    : image(&whole), mips(whole.desc.mips), layers(whole.desc.layers), type(array_type(layers)) {
    if (whole.desc.depth) type = VK_IMAGE_VIEW_TYPE_3D;
    if (whole.desc.cube) type = layers > 6 ? VK_IMAGE_VIEW_TYPE_CUBE_ARRAY : VK_IMAGE_VIEW_TYPE_CUBE;
}

ImageView ImageView::mip(uint32_t m) const {
    if (m >= mips) throw Failure("{} has no mip {}", name(), m);
    ImageView result = *this;
    result.first_mip += m;
    result.mips = 1;
    return result;
}

ImageView ImageView::all_mips() const {
    ImageView result = *this;
    result.first_mip = 0;
    result.mips = image->desc.mips;
    return result;
}

ImageView ImageView::layer_range(uint32_t first, uint32_t count) const {
    const uint32_t all = is_volume() && type == VK_IMAGE_VIEW_TYPE_3D ? size().z : layers;
    if (count == 0 || first + count > all) throw Failure("{} has no layers {} to {}", name(), first, first + count - 1);
    ImageView result = *this;
    result.first_layer += first;
    result.layers = count;
    result.type = VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    return result;
}

ImageView ImageView::layer(uint32_t i) const {
    ImageView result = layer_range(i, 1);
    result.type = VK_IMAGE_VIEW_TYPE_2D;
    return result;
}

ImageView ImageView::as_array() const { return layer_range(0, layers); }

ImageView ImageView::codes() const {
    ImageView result = *this;
    if (image->desc.format == VK_FORMAT_R8G8B8A8_SRGB) result.format = VK_FORMAT_R8G8B8A8_UNORM;
    return result;
}

glm::uvec3 ImageView::size() const {
    const glm::uvec3 whole(image->desc.size, std::max(image->desc.depth, 1u));
    return glm::max(whole >> first_mip, glm::uvec3(1));
}

bool ImageView::is_volume() const { return image->desc.depth > 0; }

VkImageSubresourceRange ImageView::range() const {
    return {.aspectMask = VkImageAspectFlags(image->is_depth() ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT),
            .baseMipLevel = first_mip,
            .levelCount = mips,
            .baseArrayLayer = first_layer,
            .layerCount = layers};
}

VkImageSubresourceLayers ImageView::first_mip_layers() const {
    return {range().aspectMask, first_mip, is_volume() ? 0 : first_layer, is_volume() ? 1 : layers};
}

// All slices of a volume are one subresource.
bool ImageView::contains(const ImageView& other) const {
    const bool holds_layers =
        image == other.image &&
        (is_volume() || (first_layer <= other.first_layer && other.first_layer + other.layers <= first_layer + layers));
    return holds_layers && first_mip <= other.first_mip && other.first_mip + other.mips <= first_mip + mips;
}

bool ImageView::overlaps(const ImageView& other) const {
    return image == other.image && meet(first_mip, mips, other.first_mip, other.mips) &&
           (is_volume() || meet(first_layer, layers, other.first_layer, other.layers));
}

std::string ImageView::name() const {
    std::string result = image->desc.name;
    const auto part = [&](const char* what, uint32_t first, uint32_t count, uint32_t all) {
        if (count == all) return;
        result += count > 1 ? fmt::format(" {}s {} to {}", what, first, first + count - 1)
                            : fmt::format(" {} {}", what, first);
    };
    const bool whole_volume = type == VK_IMAGE_VIEW_TYPE_3D;
    part(is_volume() ? "slice" : "layer", first_layer, layers, whole_volume ? 1 : is_volume() ? 0 : image->desc.layers);
    part("mip", first_mip, mips, image->desc.mips);
    return result;
}

VkImageView ImageView::handle() const {
    for (const auto& [view, made] : image->views_)
        if (view == *this) return made;
    const Device& device = *image->device_;
    const bool own = format == VK_FORMAT_UNDEFINED;
    // An sRGB image has no storage view in its own format, only through codes().
    const VkImageViewUsageCreateInfo without_storage{
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_USAGE_CREATE_INFO,
        .usage = image->usage_ & ~VkImageUsageFlags(VK_IMAGE_USAGE_STORAGE_BIT)};
    const VkImageViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                     .pNext = own && image->writes_codes_ ? &without_storage : nullptr,
                                     .image = image->handle,
                                     .viewType = type,
                                     .format = own ? image->desc.format : format,
                                     .subresourceRange = range()};
    // Stored first, so that the image owns the view even if naming it fails.
    VkImageView& made = image->views_.emplace_back(*this, VK_NULL_HANDLE).second;
    const VkResult result = vkCreateImageView(device.handle, &info, nullptr, &made);
    if (result == VK_SUCCESS) device.set_name(VK_OBJECT_TYPE_IMAGE_VIEW, reinterpret_cast<uint64_t>(made), name());
    check(result, ("view of " + name()).c_str());
    return made;
}

VkDeviceSize byte_count(const ImageView& view) {
    const glm::uvec3 size = view.size();
    return VkDeviceSize(texel_bytes(view.image->desc.format)) * size.x * size.y * size.z *
           (view.is_volume() ? 1 : view.layers);
}

}  // namespace lightwalk
