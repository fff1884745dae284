// Required device features and limits.
#pragma once
#include <vulkan/vulkan.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/gpu/device.h"

namespace lightwalk {

struct DeviceFeatures {
    explicit DeviceFeatures(VkPhysicalDevice physical);
    DeviceFeatures(const DeviceFeatures&) = delete;
    VkPhysicalDeviceFeatures2 core{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
    VkPhysicalDeviceVulkan11Features v11{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
    VkPhysicalDeviceVulkan12Features v12{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    VkPhysicalDeviceVulkan13Features v13{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    std::string lacks;
};

struct Limits {
    explicit Limits(VkPhysicalDevice physical);
    VkPhysicalDeviceVulkan13Properties core13{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES};
    uint32_t shuffling_lanes = 1;  ///< smallest subgroup size of compute shaders with shuffle support
};

DeviceInfo describe_device(VkPhysicalDevice physical);
std::optional<uint32_t> graphics_family(VkPhysicalDevice physical);

/// Preference, smallest first: discrete, integrated, virtual, other, software.
int device_rank(VkPhysicalDevice physical);

}  // namespace lightwalk
