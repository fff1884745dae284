// The device: choice of a Vulkan 1.3 driver, its queue, validation and object names.
#pragma once
#include <vulkan/vulkan.h>

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace lightwalk {

/// Throws Failure with the name of the result unless it is VK_SUCCESS.
void check(VkResult result, const char* what);

struct DeviceInfo {
    std::string name;    ///< as the driver gives it
    std::string driver;  ///< driver name and version
    std::string type;    ///< discrete, integrated, virtual, software or other
    std::string lacks;   ///< what the course needs and this device has not; empty: usable
};

/// Every Vulkan device on this machine, best first. Throws InputError where no driver is installed.
std::vector<DeviceInfo> list_devices();

struct DeviceOptions {
    std::string name;       ///< a part of the wanted device's name, or its type; empty: hardware before software
    bool validate = false;  ///< core and synchronisation validation; every message is kept
    std::vector<const char*> surface_extensions;  ///< what GLFW asks for; empty: headless, no surface at all
};

class Device {
  public:
    /// Throws InputError (no driver, no such device, validation layer missing) or Failure.
    explicit Device(const DeviceOptions& options);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice handle = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;  ///< graphics and compute
    uint32_t queue_family = 0;
    VkPhysicalDeviceProperties properties{};
    DeviceInfo info;
    PFN_vkCmdPushDescriptorSetKHR push_descriptors = nullptr;

    bool software() const { return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU; }

    /// Names an object for validation messages and frame debuggers.
    void set_name(VkObjectType type, uint64_t object, const std::string& name) const;
    void begin_label(VkCommandBuffer commands, const char* name) const;
    void end_label(VkCommandBuffer commands) const;

    /// What validation has said so far. Throws Failure with the first message where it said anything.
    void check_validation() const;
    size_t validation_message_count() const;

    /// Index of a memory type that has the properties, among the types of the mask.
    uint32_t memory_type(uint32_t type_mask, VkMemoryPropertyFlags wanted) const;

    /// How long a frame may take before it counts as one that never ends. $LIGHTWALK_TIMEOUT_S, else 60 s.
    uint64_t timeout_ns() const;

  private:
    friend VkBool32 keep_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                 const VkDebugUtilsMessengerCallbackDataEXT*, void*);
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    mutable std::mutex mutex_;
    std::vector<std::string> messages_;
    PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT begin_label_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT end_label_ = nullptr;
};

}  // namespace lightwalk
