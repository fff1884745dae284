// Named device buffer for storage, uniform, index and indirect use, freed once no frame in flight uses it.
#pragma once
#include <string>

#include "common/gpu/device.h"
#include "common/gpu/history.h"

namespace lightwalk {

class Buffer {
  public:
    struct Desc {
        std::string name;
        VkDeviceSize bytes = 0;     ///< at least 16
        bool host_visible = false;  ///< persistently mapped
    };
    Buffer() = default;
    /// Throws Failure if no memory type fits or the heap is full.
    Buffer(Device& device, const Desc& desc);
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept {
        Buffer old(std::move(*this));
        swap(other);
        return *this;
    }
    ~Buffer();

    VkBuffer handle = VK_NULL_HANDLE;
    VkDeviceSize bytes = 0;  ///< range visible to shaders
    VkDeviceSize capacity = 0;
    uint32_t stride = 0;  ///< bytes of an element, if uploaded as a vector; 0: unknown
    std::byte* mapped = nullptr;
    std::string name;
    mutable AccessHistory history;
    mutable bool constant = false;  ///< uploaded and unwritten since: readable without being declared
    explicit operator bool() const { return handle != VK_NULL_HANDLE; }

  private:
    void swap(Buffer& other) noexcept;
    Device* device_ = nullptr;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

}  // namespace lightwalk
