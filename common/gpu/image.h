// Images and image views.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "common/gpu/device.h"
#include "common/gpu/history.h"

namespace lightwalk {

class Image;

/// Range of mips and layers: `map.layer(i)`, `chain.mip(m)`, `cube.face(f).mip(m)`. Valid while the image lives. An
/// Image converts to a view of all subresources for sampling, or of its first mip as target or storage image.
struct ImageView {
    const Image* image = nullptr;
    uint32_t first_mip = 0, mips = 0;
    uint32_t first_layer = 0, layers = 0;
    VkImageViewType type = VK_IMAGE_VIEW_TYPE_2D;
    VkFormat format = VK_FORMAT_UNDEFINED;  ///< undefined: the image's format

    ImageView() = default;
    ImageView(const Image& whole);

    /// The view's m-th mip. Throws Failure if there is none.
    ImageView mip(uint32_t m) const;
    ImageView all_mips() const;
    /// The view's i-th layer as a 2-D view; for a volume the slice at depth i, usable as a target only.
    ImageView layer(uint32_t i) const;
    /// +x, -x, +y, -y, +z, -z.
    ImageView face(uint32_t i) const { return layer(i); }
    ImageView layer_range(uint32_t first, uint32_t count) const;
    /// Array view of the same layers, also for a cube or a single layer.
    ImageView as_array() const;
    /// UNORM view of an sRGB image with the encoded values, since storage images cannot encode; else the same view.
    ImageView codes() const;

    /// Size of the view's first mip in texels; z is 1 except for a volume.
    glm::uvec3 size() const;
    VkImageSubresourceRange range() const;
    VkImageSubresourceLayers first_mip_layers() const;
    VkImageView handle() const;

    bool is_volume() const;
    bool contains(const ImageView& other) const;
    bool overlaps(const ImageView& other) const;
    bool operator==(const ImageView&) const = default;
    explicit operator bool() const { return image != nullptr; }
    std::string name() const;
};

/// 2-D, array, cube or volume image. Sampled image, storage image and target, as far as the format allows.
class Image {
  public:
    struct Desc {
        std::string name;
        VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT;
        glm::uvec2 size{1};
        uint32_t mips = 1, layers = 1;  ///< a cube has a multiple of 6 layers
        bool cube = false;
        uint32_t depth = 0;  ///< texels; above 0: a volume
        uint32_t samples = 1;
        bool kept = false;  ///< contents persist across frames
        bool operator==(const Desc&) const = default;
    };
    Image() = default;
    /// Throws Failure if the device does not support such an image or lacks memory.
    Image(Device& device, const Desc& desc);
    /// Recreates the image if its description differs from `wanted`. True: recreated, contents undefined.
    bool ensure(Device& device, const Desc& wanted);
    /// Wraps an image owned elsewhere, such as a swapchain image. Views are owned here.
    static Image borrowed(Device& device, VkImage handle, const Desc& desc);
    Image(Image&& other) noexcept { swap(other); }
    Image& operator=(Image&& other) noexcept {
        Image old(std::move(*this));
        swap(other);
        return *this;
    }
    ~Image();

    VkImage handle = VK_NULL_HANDLE;
    Desc desc;
    mutable ImageHistory history;
    mutable bool constant = false;    ///< uploaded and unwritten since: readable without being declared
    mutable uint64_t written_in = 0;  ///< Frame::number() of the last frame that wrote it
    mutable uint64_t shown_in = 0;    ///< Frame::number() of the last frame that tone-mapped it
    explicit operator bool() const { return handle != VK_NULL_HANDLE; }
    bool is_storable() const { return usage_ & VK_IMAGE_USAGE_STORAGE_BIT; }
    bool is_depth() const { return desc.format == VK_FORMAT_D32_SFLOAT || desc.format == VK_FORMAT_D16_UNORM; }

    ImageView mip(uint32_t m) const { return ImageView(*this).mip(m); }
    ImageView all_mips() const { return *this; }
    ImageView layer(uint32_t i) const { return ImageView(*this).layer(i); }
    ImageView face(uint32_t i) const { return layer(i); }
    ImageView layer_range(uint32_t first, uint32_t count) const { return ImageView(*this).layer_range(first, count); }
    ImageView as_array() const { return ImageView(*this).as_array(); }
    VkImageSubresourceRange range() const { return ImageView(*this).range(); }

  private:
    friend struct ImageView;
    void swap(Image& other) noexcept;
    Device* device_ = nullptr;
    bool owned_ = true;
    VkImageUsageFlags usage_ = 0;
    bool writes_codes_ = false;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    mutable std::vector<std::pair<ImageView, VkImageView>> views_;
};

/// Bytes per texel. Throws Failure for block-compressed formats.
uint32_t texel_bytes(VkFormat format);

/// Name as in vulkan.hpp, for instance "R8G8B8A8Unorm".
std::string name_of(VkFormat format);

/// Bytes of the view's first mip, all layers, tightly packed.
VkDeviceSize byte_count(const ImageView& view);

uint32_t full_mip_count(glm::uvec2 size);

}  // namespace lightwalk
