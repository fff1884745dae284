// Vulkan 1.3 device: selection, queue, validation, object names, deferred destruction.
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

/// Throws Failure with the name of `result` unless it is VK_SUCCESS.
void check(VkResult result, const char* what);

/// Name as in vulkan.hpp, for instance "ErrorOutOfDeviceMemory".
std::string name_of(VkResult result);

/// Fault injection for tests: number of check() calls that succeed before one throws; negative: no fault.
int& checks_until_failure();

struct DeviceInfo {
    std::string name;
    std::string driver;
    std::string type;   ///< discrete, integrated, virtual, software or other
    std::string lacks;  ///< missing required features; empty: usable
};

/// Every Vulkan device of this machine, best first. Throws InputError if no driver is installed.
std::vector<DeviceInfo> list_devices();

struct DeviceOptions {
    std::string name;                      ///< part of a device name, or a device type; empty: hardware before software
    bool validate = false;                 ///< core and synchronisation validation
    std::optional<bool> software_paths{};  ///< forces Device::software_paths, so that tests run both sides
    std::vector<const char*> surface_extensions;  ///< GLFW's extensions; empty: headless
    /// Whether a device can draw into the window: the first that can is taken where none is named.
    std::function<bool(VkInstance, VkPhysicalDevice, uint32_t queue_family)> presents = {};

    std::function<void(const char*)> on_message;  ///< receives every message until the device is destroyed
};

/// Vulkan objects of one resource, destroyed together once no frame uses them.
struct Retired {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkImage image = VK_NULL_HANDLE;
    std::vector<VkImageView> views;
    VkDeviceMemory memory = VK_NULL_HANDLE;
};

class Device {
  public:
    /// Throws InputError (no driver, no such device, no validation layer) or Failure.
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
    bool software_paths = false;  ///< side of each branch by device (docs/devices.md#what-differs-between-devices)

    bool software() const { return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU; }

    void set_name(VkObjectType type, uint64_t object, const std::string& name) const;
    void begin_label(VkCommandBuffer commands, const char* name) const;
    void end_label(VkCommandBuffer commands) const;

    /// Throws Failure with the first validation message after the first `heard` ones.
    void check_validation(size_t heard = 0) const;
    size_t validation_message_count() const;

    /// Throws Failure if no memory type has `properties` or the heap is too small. `name` appears in the error.
    VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties,
                            const std::string& name) const;

    /// Time limit of one pass, in ns: $LIGHTWALK_TIMEOUT_S, default 60 s. Throws InputError for an invalid value.
    uint64_t timeout_ns() const;

    /// Frames in use. Objects passed to destroy() are kept until every frame begun before that call has ended.
    uint64_t begin_use();
    void end_use(uint64_t use);
    /// True while this thread records a frame: from begin_use() to end_recording() or end_use().
    bool is_recording() const;
    void end_recording(uint64_t use);
    void destroy(Retired objects);
    size_t retired_count() const { return retired_.size(); }

  private:
    Device() = default;  // delegated to: ensures the destructor runs if construction fails
    void destroy_now(const Retired& objects);
    std::vector<uint64_t> uses_;
    std::vector<std::pair<uint64_t, std::thread::id>> recording_;
    uint64_t last_use_ = 0;
    std::vector<std::pair<uint64_t, Retired>> retired_;

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
