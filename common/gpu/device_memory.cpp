// Device memory: allocation and deferred destruction.
#include <algorithm>
#include <utility>

#include "common/base/error.h"
#include "common/base/shared_lock.h"
#include "common/gpu/device.h"
#include "common/gpu/gpu_work.h"

namespace lightwalk {

VkDeviceMemory Device::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties_wanted,
                                const std::string& name) const {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    uint32_t type = 0;
    const auto fits = [&] {
        return (needs.memoryTypeBits >> type & 1) &&
               (memory.memoryTypes[type].propertyFlags & properties_wanted) == properties_wanted;
    };
    while (type < memory.memoryTypeCount && !fits()) ++type;
    if (type == memory.memoryTypeCount) throw Failure("the device has no memory of the kind that {} needs", name);
    const VkDeviceSize heap = memory.memoryHeaps[memory.memoryTypes[type].heapIndex].size;
    if (needs.size > heap) throw Failure("{} needs {} MiB, and the device has {}", name, needs.size >> 20, heap >> 20);
    const VkMemoryAllocateInfo allocate_info{
        .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needs.size, .memoryTypeIndex = type};
    VkDeviceMemory result = VK_NULL_HANDLE;
    ++gpu_work.allocations;
    const VkResult made = unlocked([&] { return vkAllocateMemory(handle, &allocate_info, nullptr, &result); });
    if (made == VK_SUCCESS) set_name(VK_OBJECT_TYPE_DEVICE_MEMORY, reinterpret_cast<uint64_t>(result), name);
    try {
        check(made, ("memory of " + name).c_str());
    } catch (...) {
        vkFreeMemory(handle, result, nullptr);
        throw;
    }
    return result;
}

uint64_t Device::begin_use() {
    uses_.push_back(++last_use_);
    recording_.emplace_back(last_use_, std::this_thread::get_id());
    return last_use_;
}

bool Device::is_recording() const {
    return std::ranges::any_of(recording_, [](const auto& one) { return one.second == std::this_thread::get_id(); });
}

void Device::end_recording(uint64_t use) {
    std::erase_if(recording_, [&](const auto& one) { return one.first == use; });
}

void Device::end_use(uint64_t use) {
    end_recording(use);
    std::erase(uses_, use);
    const uint64_t oldest = uses_.empty() ? UINT64_MAX : *std::min_element(uses_.begin(), uses_.end());
    std::erase_if(retired_, [&](const auto& entry) {
        const bool unused = entry.first < oldest;
        if (unused) destroy_now(entry.second);
        return unused;
    });
}

void Device::destroy(Retired objects) {
    if (uses_.empty())
        destroy_now(objects);
    else
        retired_.emplace_back(last_use_, std::move(objects));
}

void Device::destroy_now(const Retired& objects) {
    for (const VkImageView view : objects.views) vkDestroyImageView(handle, view, nullptr);
    vkDestroyImage(handle, objects.image, nullptr);
    vkDestroyBuffer(handle, objects.buffer, nullptr);
    vkFreeMemory(handle, objects.memory, nullptr);
}

}  // namespace lightwalk
