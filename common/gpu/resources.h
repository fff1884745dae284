// Buffers and images: one device allocation each, named, freed by their owner. Each remembers how it was last used,
// from which a pass derives its barriers.
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/gpu/device.h"

namespace lightwalk {

/// How a pass touches a resource: the other half of a barrier.
struct Access {
    VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_NONE;
    VkAccessFlags2 access = VK_ACCESS_2_NONE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    bool writes = false;
};

/// The last write and the reads since then, kept per resource.
struct AccessHistory {
    Access last_write;
    VkPipelineStageFlags2 readers = VK_PIPELINE_STAGE_2_NONE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

/// A contiguous run of device memory, usable as storage, uniform, index and indirect buffer alike.
class Buffer {
  public:
    struct Desc {
        std::string name;
        VkDeviceSize bytes = 0;
        bool host_visible = false;  ///< mapped for its whole life
    };
    Buffer() = default;
    Buffer(Device& device, const Desc& desc);
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Buffer();

    VkBuffer handle = VK_NULL_HANDLE;
    VkDeviceSize bytes = 0;
    std::byte* mapped = nullptr;
    std::string name;
    mutable AccessHistory history;
    bool constant = false;  ///< written once by upload(): every pass may read it without saying so
    explicit operator bool() const { return handle != VK_NULL_HANDLE; }

  private:
    void swap(Buffer& other) noexcept;
    Device* device_ = nullptr;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

/// A 2-D image with mips and layers, and a view of all of it.
class Image {
  public:
    struct Desc {
        std::string name;
        VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT;
        glm::uvec2 size{1};
        uint32_t mips = 1, layers = 1;
        bool cube = false;
        bool operator==(const Desc&) const = default;
    };
    Image() = default;
    Image(Device& device, const Desc& desc);
    Image(Image&& other) noexcept { swap(other); }
    Image& operator=(Image&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Image();

    VkImage handle = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    Desc desc;
    mutable AccessHistory history;
    bool constant = false;
    explicit operator bool() const { return handle != VK_NULL_HANDLE; }
    bool is_depth() const { return desc.format == VK_FORMAT_D32_SFLOAT || desc.format == VK_FORMAT_D16_UNORM; }
    VkImageSubresourceRange range() const;

    /// A view of one mip level, made on first use.
    VkImageView mip_view(uint32_t mip) const;

  private:
    void swap(Image& other) noexcept;
    Device* device_ = nullptr;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    mutable std::vector<VkImageView> mip_views_;
};

/// Bytes of one texel of the formats the course uses. Throws Failure for others.
uint32_t texel_bytes(VkFormat format);

/// Number of mip levels down to 1×1.
uint32_t full_mip_count(glm::uvec2 size);

enum class Sampling { linear_repeat, linear_clamp, nearest_clamp, nearest_repeat };

/// The samplers, made once per device.
class Samplers {
  public:
    explicit Samplers(Device& device);
    ~Samplers();
    Samplers(const Samplers&) = delete;
    VkSampler operator[](Sampling sampling) const { return samplers_[static_cast<size_t>(sampling)]; }

  private:
    Device& device_;
    std::vector<VkSampler> samplers_;
};

}  // namespace lightwalk
