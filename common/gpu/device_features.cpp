#include "common/gpu/device_features.h"

#include <fmt/core.h>

namespace lightwalk {
namespace {

#define FEATURE(name) \
    { #name, &VkPhysicalDeviceFeatures::name }
constexpr std::pair<const char*, VkBool32 VkPhysicalDeviceFeatures::*> needed_core[] = {
    FEATURE(samplerAnisotropy),
    FEATURE(fragmentStoresAndAtomics),
    FEATURE(depthClamp),
    FEATURE(depthBiasClamp),
    FEATURE(independentBlend),
    FEATURE(dualSrcBlend),
    FEATURE(imageCubeArray),
    FEATURE(geometryShader),
    FEATURE(multiDrawIndirect),
    FEATURE(drawIndirectFirstInstance),
    FEATURE(shaderStorageImageWriteWithoutFormat),
    FEATURE(shaderUniformBufferArrayDynamicIndexing),
};
#undef FEATURE

}  // namespace

DeviceFeatures::DeviceFeatures(VkPhysicalDevice physical) {
    VkPhysicalDeviceVulkan13Features has13{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceVulkan12Features has12{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES,
                                           .pNext = &has13};
    VkPhysicalDeviceFeatures2 has{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, .pNext = &has12};
    vkGetPhysicalDeviceFeatures2(physical, &has);
    core.pNext = &v11;
    v11.pNext = &v12;
    v12.pNext = &v13;
    const auto need = [&](VkBool32 present, VkBool32& wanted, const char* name) {
        wanted = present;
        if (!present) lacks += (lacks.empty() ? "" : ", ") + std::string(name);
    };
    need(has12.scalarBlockLayout, v12.scalarBlockLayout, "scalarBlockLayout");
    need(has12.timelineSemaphore, v12.timelineSemaphore, "timelineSemaphore");
    need(has12.hostQueryReset, v12.hostQueryReset, "hostQueryReset");
    need(has13.dynamicRendering, v13.dynamicRendering, "dynamicRendering");
    need(has13.synchronization2, v13.synchronization2, "synchronization2");
    need(has13.maintenance4, v13.maintenance4, "maintenance4");
    for (const auto& [name, member] : needed_core) need(has.features.*member, core.features.*member, name);
}

Limits::Limits(VkPhysicalDevice physical) {
    VkPhysicalDeviceSubgroupProperties subgroup{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES};
    core13.pNext = &subgroup;
    VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &core13};
    vkGetPhysicalDeviceProperties2(physical, &properties);
    core13.pNext = nullptr;
    if ((subgroup.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) &&
        (subgroup.supportedOperations & VK_SUBGROUP_FEATURE_SHUFFLE_BIT))
        shuffling_lanes = core13.minSubgroupSize;
}

std::optional<uint32_t> graphics_family(VkPhysicalDevice physical) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (uint32_t i = 0; i < count; ++i)
        if ((families[i].queueFlags & both) == both && families[i].timestampValidBits > 0) return i;
    return std::nullopt;
}

int device_rank(VkPhysicalDevice physical) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    switch (properties.deviceType) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return 0;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return 1;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return 2;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return 4;
        default:
            return 3;
    }
}

DeviceInfo describe_device(VkPhysicalDevice physical) {
    VkPhysicalDeviceDriverProperties driver{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &driver};
    vkGetPhysicalDeviceProperties2(physical, &properties);
    constexpr const char* types[] = {"discrete", "integrated", "virtual", "other", "software"};
    DeviceInfo info{.name = properties.properties.deviceName,
                    .driver = fmt::format("{} {}", driver.driverName, driver.driverInfo),
                    .type = types[device_rank(physical)],
                    .lacks = {}};
    if (properties.properties.apiVersion < VK_API_VERSION_1_3) {
        info.lacks = "Vulkan 1.3";
        return info;
    }
    info.lacks = DeviceFeatures(physical).lacks;
    const auto lack = [&](const char* what) { info.lacks += (info.lacks.empty() ? "" : ", ") + std::string(what); };
    if (!graphics_family(physical)) lack("a graphics and compute queue with timestamps");
    return info;
}

}  // namespace lightwalk
