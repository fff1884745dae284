// The device: choice of a Vulkan 1.3 driver, its queue, validation and object names.
#pragma once
#include <vulkan/vulkan.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace lightwalk {

/// Throws Failure with the name of the result unless it is VK_SUCCESS.
void check(VkResult result, const char* what);

/// As the Vulkan headers spell it, such as "ErrorOutOfDeviceMemory".
std::string name_of(VkResult result);

/// For tests of failures: number of calls of check() that still succeed before one throws; below 0: all.
int& checks_until_failure();

struct DeviceInfo {
    std::string name;    ///< as the driver gives it
    std::string driver;  ///< driver name and version
    std::string type;    ///< discrete, integrated, virtual, software or other
    std::string lacks;   ///< required features that this device lacks; empty: usable
};

/// Every Vulkan device on this machine, best first. Throws InputError if no driver is installed.
std::vector<DeviceInfo> list_devices();

struct DeviceOptions {
    std::string name;       ///< a part of the wanted device's name, or its type; empty: hardware before software
    bool validate = false;  ///< core and synchronisation validation; every message is kept
    std::optional<bool> software_paths{};         ///< forces Device::software_paths, so that tests run both sides
    std::vector<const char*> surface_extensions;  ///< required by GLFW; empty: headless, no surface at all

    std::function<void(const char*)> on_message;  ///< also receives validation messages, until destruction ends
};

/// Objects of one resource, to be destroyed together.
struct Doomed {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkImage image = VK_NULL_HANDLE;
    std::vector<VkImageView> views;
    VkDeviceMemory memory = VK_NULL_HANDLE;
};

/// Large (19 functions, 21 members): Vulkan's handles and limits.
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
    VkDeviceSize max_buffer_bytes = 0;
    DeviceInfo info;
    bool software_paths =
        false;  ///< side taken of each branch by device (docs/framework.md#what-differs-between-devices)

    bool software() const { return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU; }

    /// Names an object for validation messages and frame debuggers.
    void set_name(VkObjectType type, uint64_t object, const std::string& name) const;
    void begin_label(VkCommandBuffer commands, const char* name) const;
    void end_label(VkCommandBuffer commands) const;

    /// Throws Failure with the first of validation's messages after `heard` of them, where there are any.
    void check_validation(size_t heard = 0) const;
    size_t validation_message_count() const;

    /// Allocates memory for `name`. Throws Failure if no type has the properties, or its heap is too small.
    VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties,
                            const std::string& name) const;

    /// How long one pass may take before it counts as endless. $LIGHTWALK_TIMEOUT_S, else 60 s. May throw InputError.
    uint64_t timeout_ns() const;

    /// Between the two a frame is recorded or runs: objects given to destroy() meanwhile are destroyed after all
    /// frames begun before have ended.
    uint64_t begin_use();
    void end_use(uint64_t use);
    /// This thread records a frame: from begin_use() to end_recording() or end_use().
    bool is_recording() const;
    void end_recording(uint64_t use);
    void destroy(Doomed objects);
    size_t doomed_count() const { return doomed_.size(); }

  private:
    Device() = default;  // the other constructor goes on from it, so that the destructor runs where that throws
    void destroy_now(const Doomed& objects);
    std::vector<uint64_t> uses_;
    std::vector<std::pair<uint64_t, std::thread::id>> recording_;
    uint64_t last_use_ = 0;
    std::vector<std::pair<uint64_t, Doomed>> doomed_;  ///< with the last frame that had begun

    friend VkBool32 keep_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                 const VkDebugUtilsMessengerCallbackDataEXT*, void*);
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    mutable std::mutex mutex_;
    std::vector<std::string> messages_;
    std::function<void(const char*)> on_message_;
    PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT begin_label_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT end_label_ = nullptr;
};

}  // namespace lightwalk
