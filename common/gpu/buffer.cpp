#include "common/gpu/buffer.h"

#include <algorithm>
#include <utility>

#include "common/base/error.h"

namespace lightwalk {

Buffer::Buffer(Device& device, const Desc& desc) : Buffer() {
    device_ = &device;
    name = desc.name;
    bytes = capacity = std::max<VkDeviceSize>(desc.bytes, 16);
    if (bytes > device.max_buffer_bytes)
        throw Failure("buffer {} of {} bytes: the device's have at most {}", name, bytes, device.max_buffer_bytes);
    const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                  .size = bytes,
                                  .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                                           VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                                           VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT};
    check(vkCreateBuffer(device.handle, &info, nullptr, &handle), ("buffer " + name).c_str());
    device.set_name(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<uint64_t>(handle), name);
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device.handle, handle, &needs);
    memory_ =
        device.allocate(needs,
                        desc.host_visible ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT
                                          : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT,
                        "buffer " + name);
    check(vkBindBufferMemory(device.handle, handle, memory_, 0), "vkBindBufferMemory");
    if (desc.host_visible) {
        void* address = nullptr;
        check(vkMapMemory(device.handle, memory_, 0, VK_WHOLE_SIZE, 0, &address), "vkMapMemory");
        mapped = static_cast<std::byte*>(address);
    }
}

Buffer::~Buffer() {
    if (device_) device_->destroy({.buffer = handle, .memory = memory_});
}

void Buffer::swap(Buffer& other) noexcept {
    std::swap(handle, other.handle);
    std::swap(bytes, other.bytes);
    std::swap(capacity, other.capacity);
    std::swap(stride, other.stride);
    std::swap(mapped, other.mapped);
    std::swap(name, other.name);
    std::swap(history, other.history);
    std::swap(constant, other.constant);
    std::swap(device_, other.device_);
    std::swap(memory_, other.memory_);
}

}  // namespace lightwalk
