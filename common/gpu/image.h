// Images and views of their parts, which go wherever an image goes.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "common/gpu/device.h"
#include "common/gpu/history.h"

namespace lightwalk {

class Image;

/// Some mips and layers of an image: `map.layer(i)`, `chain.mip(m)`, `cube.face(f).mip(m)`. A value, valid while the
/// image lives. An image alone means all of it when sampled, and its first mip as a target or storage image.
struct ImageView {
    const Image* image = nullptr;
    uint32_t first_mip = 0, mips = 0;
    uint32_t first_layer = 0, layers = 0;
    VkImageViewType type = VK_IMAGE_VIEW_TYPE_2D;
    VkFormat format = VK_FORMAT_UNDEFINED;  ///< undefined: the image's own

    ImageView() = default;
    ImageView(const Image& whole);

    /// The m-th of the view's mips alone. Throws Failure if there is none.
    ImageView mip(uint32_t m) const;
    /// The view with every mip of the image.
    ImageView all_mips() const;
    /// The i-th of the view's layers alone, as a 2-D image; of a volume the slice at depth i, as a target alone.
    ImageView layer(uint32_t i) const;
    /// Layer i of a cube: +x, -x, +y, -y, +z, -z.
    ImageView face(uint32_t i) const { return layer(i); }
    /// `count` of the view's layers from `first` on, as an array.
    ImageView layer_range(uint32_t first, uint32_t count) const;
    /// The same layers as an array, though the image is a cube or has one layer.
    ImageView as_array() const;
    /// The codes of an sRGB image as they are, R8G8B8A8_UNORM, to be read or written: no storage image encodes. Any
    /// other view is returned as it is.
    ImageView codes() const;

    /// Of its first mip, in texels; z is 1 but for a volume.
    glm::uvec3 size() const;
    VkImageSubresourceRange range() const;
    VkImageSubresourceLayers first_mip_layers() const;
    /// The Vulkan view, made on first use and kept in the image.
    VkImageView handle() const;

    bool is_volume() const;
    bool contains(const ImageView& other) const;
    bool overlaps(const ImageView& other) const;
    bool operator==(const ImageView&) const = default;
    explicit operator bool() const { return image != nullptr; }
    std::string name() const;  ///< "bloom mip 2"
};

/// With mips and layers, or a volume. Colour or depth, to be sampled, written as storage image and drawn into where the
/// format allows.
/// Large (17 functions, 12 members): an image and its views.
class Image {
  public:
    struct Desc {
        std::string name;
        VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT;
        glm::uvec2 size{1};             ///< texels
        uint32_t mips = 1, layers = 1;  ///< a cube has 6 layers, or a multiple of them
        bool cube = false;
        uint32_t depth = 0;    ///< texels; above 0 it is a volume
        uint32_t samples = 1;  ///< a power of two
        bool kept = false;     ///< later frames read its contents
        bool operator==(const Desc&) const = default;
    };
    Image() = default;
    /// Throws Failure if the device has no such image, or not as much memory.
    Image(Device& device, const Desc& desc);
    /// Recreates it if it differs from `wanted`; true if it did, with undefined contents.
    bool fit(Device& device, const Desc& wanted);
    /// An image that belongs to another, such as a swapchain; its views are this one's.
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
    mutable bool constant = false;    ///< uploaded, not written since: every pass may read it without saying so
    mutable uint64_t written_in = 0;  ///< Frame::number() of the last frame that wrote it
    mutable uint64_t shown_in = 0;    ///< of the frame that applied a tone curve to it: no longer linear light
    explicit operator bool() const { return handle != VK_NULL_HANDLE; }
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
    bool writes_codes_ = false;  ///< its storage views are codes()
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    mutable std::vector<std::pair<ImageView, VkImageView>> views_;
};

/// Bytes of one texel. Throws Failure for block-compressed formats.
uint32_t texel_bytes(VkFormat format);

/// As the Vulkan headers spell it, such as "R8G8B8A8Unorm".
std::string name_of(VkFormat format);

/// Of the view's first mip, all its layers, tightly packed.
VkDeviceSize byte_count(const ImageView& view);

/// Number of mip levels down to 1×1.
uint32_t full_mip_count(glm::uvec2 size);

}  // namespace lightwalk
