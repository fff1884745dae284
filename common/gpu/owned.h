// Owns one Vulkan object: if a constructor throws, the objects made so far are destroyed.
#pragma once
#include <vulkan/vulkan.h>

#include <utility>

namespace lightwalk {

/// `Owned<VkFence, vkDestroyFence> fence; vkCreateFence(device, &info, nullptr, fence.put(device));`
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

    /// Where a vkCreate function writes the handle. Only for one that is empty.
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
