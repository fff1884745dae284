// A contiguous run of device memory, named, freed by its owner once no frame uses it any more.
#pragma once
#include <string>

#include "common/gpu/device.h"
#include "common/gpu/history.h"

namespace lightwalk {

/// Usable as storage, uniform, index and indirect buffer alike.
/// Large (7 functions, 9 members): Vulkan's handles.
class Buffer {
  public:
    struct Desc {
        std::string name;
        VkDeviceSize bytes = 0;     ///< 16 at least
        bool host_visible = false;  ///< mapped for its whole life
    };
    Buffer() = default;
    /// Throws Failure if the device has no such memory, or not as much.
    Buffer(Device& device, const Desc& desc);
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept {
        Buffer old(std::move(*this));
        swap(other);
        return *this;
    }
    ~Buffer();

    VkBuffer handle = VK_NULL_HANDLE;
    VkDeviceSize bytes = 0;     ///< visible to shaders
    VkDeviceSize capacity = 0;  ///< bytes that `bytes` may be set to without another allocation
    std::byte* mapped = nullptr;
    std::string name;
    mutable AccessHistory history;
    mutable bool constant = false;  ///< uploaded, not written since: every pass may read it without saying so
    explicit operator bool() const { return handle != VK_NULL_HANDLE; }

  private:
    void swap(Buffer& other) noexcept;
    Device* device_ = nullptr;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

}  // namespace lightwalk
