// RAII handle of a Vulkan object.
#pragma once
#include <vulkan/vulkan.h>

#include <utility>

namespace lightwalk {

/// Example: `Owned<VkFence, vkDestroyFence> fence; vkCreateFence(device, &info, nullptr, fence.put(device));`
template <class T, auto destroy>
class Owned {
  public:
    Owned() = default;
    Owned(Owned&& other) noexcept { swap(other); }
    Owned& operator=(Owned&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Owned() {
        if (handle_) destroy(device_, handle_, nullptr);
    }
    operator T() const { return handle_; }
    const T* address() const { return &handle_; }

    /// Output argument for a vkCreate function. The handle must be empty.
    T* put(VkDevice device) {
        device_ = device;
        return &handle_;
    }

  private:
    void swap(Owned& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(handle_, other.handle_);
    }
    VkDevice device_ = VK_NULL_HANDLE;
    T handle_ = VK_NULL_HANDLE;
};

}  // namespace lightwalk
