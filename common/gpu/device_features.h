// Device features required by the course, in one place.
#pragma once
#include <vulkan/vulkan.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/gpu/device.h"

namespace lightwalk {

constexpr const char* no_driver_message =
    "no Vulkan driver is installed; a graphics card's own, or for software rendering: apt install mesa-vulkan-drivers";

/// The features to enable.
struct DeviceFeatures {
    explicit DeviceFeatures(VkPhysicalDevice physical);
    DeviceFeatures(const DeviceFeatures&) = delete;
    VkPhysicalDeviceFeatures2 core{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
    VkPhysicalDeviceVulkan11Features v11{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
    VkPhysicalDeviceVulkan12Features v12{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    VkPhysicalDeviceVulkan13Features v13{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    std::string lacks;  ///< names of needed features that are absent
};

/// Device limits beyond VkPhysicalDeviceProperties.
struct Limits {
    explicit Limits(VkPhysicalDevice physical);
    VkPhysicalDeviceVulkan13Properties core13{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES};
    uint32_t shuffling_lanes = 1;  ///< invocations of the smallest subgroup that compute shaders may run in and shuffle
};

DeviceInfo describe_device(VkPhysicalDevice physical);
std::optional<uint32_t> graphics_family(VkPhysicalDevice physical);

/// Smaller is preferred: discrete, integrated, virtual, other, software.
int device_rank(VkPhysicalDevice physical);

}  // namespace lightwalk
