#include "common/gpu/device.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>

#include "common/base/error.h"
#include "common/base/names.h"
#include "common/base/shared_lock.h"
#include "common/gpu/capture.h"
#include "common/gpu/device_features.h"
#include "common/gpu/device_wait.h"

namespace lightwalk {

int& checks_until_failure() {
    static int left = -1;
    return left;
}

void check(VkResult result, const char* what) {
    if (checks_until_failure() >= 0 && checks_until_failure()-- == 0) throw Failure("{}: forced", what);
    if (result == VK_ERROR_DEVICE_LOST)
        throw Failure("{}: the device was lost: it was reset, or a shader ran too long; --device NAME takes another",
                      what);
    if (result != VK_SUCCESS) throw Failure("{}: {}", what, name_of(result));
}

VkBool32 keep_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                      const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    auto* device = static_cast<Device*>(user);
    const std::lock_guard lock(device->mutex_);
    device->messages_.push_back(data->pMessage);
    if (device->on_message_) device->on_message_(data->pMessage);
    return VK_FALSE;
}

namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

bool has_layer(const char* name) {
    uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> all(count);
    vkEnumerateInstanceLayerProperties(&count, all.data());
    return std::any_of(all.begin(), all.end(), [&](const auto& l) { return !std::strcmp(l.layerName, name); });
}

// The first manifest of a driver or a layer that is no JSON: for one of them some releases of the loader load nothing.
std::filesystem::path broken_manifest() {
    const char* const home = std::getenv("HOME");
    const std::string own = std::string(home ? home : "") + "/.local/share";
    for (const char* root : {"/etc", "/usr/local/etc", "/usr/local/share", "/usr/share", own.c_str()})
        for (const char* kind : {"icd.d", "implicit_layer.d"}) {
            std::error_code none;
            for (const auto& entry : std::filesystem::directory_iterator(root + std::string("/vulkan/") + kind, none))
                if (std::ifstream file(entry.path());
                    entry.path().extension() == ".json" && !nlohmann::json::accept(file))
                    return entry.path();
        }
    return {};
}

// Vulkan's loader takes no other drivers than those of the variables, where one of these is set.
InputError no_driver() {
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"})
        if (const char* value = std::getenv(name))
            return InputError("no Vulkan driver is found by {}={}; type unset {}", name, value, name);
    if (const std::string file = broken_manifest().string(); !file.empty())
        return InputError("{} is no JSON, and for that the Vulkan loader refuses all drivers; type{} mv {} {}.broken",
                          file, access(file.substr(0, file.rfind('/')).c_str(), W_OK) ? ", as root:" : "", file, file);
    return InputError(
        "no Vulkan driver is installed; a graphics card's own, or for software rendering, as root: apt-get install "
        "mesa-vulkan-drivers");
}

VkInstance make_instance(const DeviceOptions& options) {
    const VkApplicationInfo app{
        .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .pApplicationName = "Lightwalk", .apiVersion = VK_API_VERSION_1_3};
    std::vector<const char*> extensions = options.surface_extensions;
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);  // of Vulkan's loader itself
    const VkValidationFeatureEnableEXT synchronisation = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    const VkValidationFeaturesEXT features{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                           .enabledValidationFeatureCount = 1,
                                           .pEnabledValidationFeatures = &synchronisation};
    if (options.validate && !has_layer(validation_layer))
        throw InputError("--validate on needs the Vulkan validation layer: apt install vulkan-validationlayers");
    // Shader accesses are unchecked by default since 1.3.290. Debian 12's headers lack VK_EXT_layer_settings.
    if (options.validate) setenv("VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC", "true", 0);
    const VkInstanceCreateInfo create{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                      .pNext = options.validate ? &features : nullptr,
                                      .pApplicationInfo = &app,
                                      .enabledLayerCount = options.validate ? 1u : 0u,
                                      .ppEnabledLayerNames = &validation_layer,
                                      .enabledExtensionCount = static_cast<uint32_t>(extensions.size()),
                                      .ppEnabledExtensionNames = extensions.data()};
    VkInstance instance = VK_NULL_HANDLE;
    const VkResult result = vkCreateInstance(&create, nullptr, &instance);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER || result == VK_ERROR_OUT_OF_HOST_MEMORY) throw no_driver();
    check(result, "vkCreateInstance");
    return instance;
}

std::vector<VkPhysicalDevice> physical_devices(VkInstance instance) {
    uint32_t count = 0;
    vkEnumeratePhysicalDevices(instance, &count, nullptr);
    std::vector<VkPhysicalDevice> all(count);
    vkEnumeratePhysicalDevices(instance, &count, all.data());
    if (all.empty()) throw no_driver();
    std::stable_sort(all.begin(), all.end(), [](auto a, auto b) { return device_rank(a) < device_rank(b); });
    return all;
}

VkPhysicalDevice choose(const std::vector<VkPhysicalDevice>& all, VkInstance instance, const DeviceOptions& options) {
    const std::string& wanted = options.name;
    std::string known, passed;
    for (const VkPhysicalDevice physical : all) {
        const DeviceInfo info = describe_device(physical);
        const bool named =
            lowercase(info.name).find(lowercase(wanted)) != std::string::npos || info.type == lowercase(wanted);
        const bool usable = named && info.lacks.empty();
        if (usable && wanted.empty() && options.presents &&
            !options.presents(instance, physical, *graphics_family(physical))) {
            passed += (passed.empty() ? "" : ", ") + info.name;  // a card beside a remote desktop
            continue;
        }
        if (usable && !passed.empty())
            fmt::print(stderr, "{} cannot draw into this window; {} does\n", passed, info.name);
        if (usable) return physical;
        known += fmt::format("{}{} ({}{})", known.empty() ? "" : ", ", info.name, info.type,
                             info.lacks.empty() ? "" : ", lacks " + info.lacks);
    }
    if (has_renderdoc() && known.find("lacks Vulkan 1.3") != std::string::npos)
        throw InputError(
            "--capture: RenderDoc hides Vulkan 1.3 of drivers that cannot replay the addresses of buffers, as "
            "lavapipe: {}",
            known);
    if (!passed.empty())
        throw InputError(
            "no device can draw into this window, neither {}; without one: ./course run 02 --screenshot picture.png",
            passed);
    if (wanted.empty()) throw InputError("no device has what the course needs: {}", known);
    throw InputError("--device {}: no usable device of that name; there are: {}", wanted, known);
}

// Throws Failure where the system does not start the threads of lavapipe, which would wait for them without end: one for each
// core, and a few for its queue and its cache.
void require_threads() {
    const char* const given = std::getenv("LP_NUM_THREADS");
    const int count =
        (given ? std::atoi(given) : static_cast<int>(std::min(std::thread::hardware_concurrency(), 32u))) + 5;
    std::atomic<bool> go = false;
    std::vector<std::jthread> threads;
    try {
        for (int i = 0; i < count; ++i) threads.emplace_back([&] { go.wait(false); });
    } catch (const std::system_error&) {}
    go = true;
    go.notify_all();
    if (static_cast<int>(threads.size()) < count)
        throw Failure(
            "this machine starts {} threads of the {} that its software driver needs: raise ulimit -u, or the limit of "
            "the container's processes",
            threads.size(), count);
}

template <class F>
void load(VkInstance instance, F& function, const char* name) {
    function = reinterpret_cast<F>(vkGetInstanceProcAddr(instance, name));
}

}  // namespace

std::vector<DeviceInfo> list_devices() {
    const VkInstance instance = make_instance({});
    std::vector<DeviceInfo> result;
    try {
        for (const VkPhysicalDevice physical : physical_devices(instance)) result.push_back(describe_device(physical));
    } catch (...) {
        vkDestroyInstance(instance, nullptr);
        throw;
    }
    vkDestroyInstance(instance, nullptr);
    return result;
}

Device::Device(const DeviceOptions& options) : Device() {
    on_message_ = options.on_message;
    instance = make_instance(options);
    load(instance, set_name_, "vkSetDebugUtilsObjectNameEXT");
    load(instance, begin_label_, "vkCmdBeginDebugUtilsLabelEXT");
    load(instance, end_label_, "vkCmdEndDebugUtilsLabelEXT");
    if (options.validate) {
        const VkDebugUtilsMessengerCreateInfoEXT create{
            .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
            .messageSeverity =
                VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
            .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
            .pfnUserCallback = keep_message,
            .pUserData = this};
        PFN_vkCreateDebugUtilsMessengerEXT create_messenger = nullptr;
        load(instance, create_messenger, "vkCreateDebugUtilsMessengerEXT");
        check(create_messenger(instance, &create, nullptr, &messenger_), "vkCreateDebugUtilsMessengerEXT");
    }
    timeout_ns();  // rejects an invalid value early
    physical = choose(physical_devices(instance), instance, options);
    vkGetPhysicalDeviceProperties(physical, &properties);
    const Limits limits(physical);
    software_paths = options.software_paths.value_or(software());
    max_buffer_bytes = limits.core13.maxBufferSize;
    info = describe_device(physical);
    queue_family = *graphics_family(physical);

    const float priority = 1.0f;
    const VkDeviceQueueCreateInfo queues{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                         .queueFamilyIndex = queue_family,
                                         .queueCount = 1,
                                         .pQueuePriorities = &priority};
    DeviceFeatures features(physical);
    std::vector<const char*> extensions;
    if (!options.surface_extensions.empty()) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    const VkDeviceCreateInfo create{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                    .pNext = &features.core,
                                    .queueCreateInfoCount = 1,
                                    .pQueueCreateInfos = &queues,
                                    .enabledExtensionCount = static_cast<uint32_t>(extensions.size()),
                                    .ppEnabledExtensionNames = extensions.data()};
    if (software()) require_threads();
    check(vkCreateDevice(physical, &create, nullptr, &handle), "vkCreateDevice");
    set_name(VK_OBJECT_TYPE_DEVICE, reinterpret_cast<uint64_t>(handle), info.name);
    vkGetDeviceQueue(handle, queue_family, 0, &queue);
    set_name(VK_OBJECT_TYPE_QUEUE, reinterpret_cast<uint64_t>(queue), "graphics and compute");
}

Device::~Device() {
    if (handle) {
        for (const auto& [use, objects] : retired_) destroy_now(objects);
        vkDestroyDevice(handle, nullptr);
    }
    if (messenger_) {
        PFN_vkDestroyDebugUtilsMessengerEXT destroy_messenger = nullptr;
        load(instance, destroy_messenger, "vkDestroyDebugUtilsMessengerEXT");
        destroy_messenger(instance, messenger_, nullptr);
    }
    if (instance) vkDestroyInstance(instance, nullptr);
}

void Device::set_name(VkObjectType type, uint64_t object, const std::string& name) const {
    const VkDebugUtilsObjectNameInfoEXT info_name{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                                                  .objectType = type,
                                                  .objectHandle = object,
                                                  .pObjectName = name.c_str()};
    set_name_(handle, &info_name);
}

void Device::begin_label(VkCommandBuffer commands, const char* name) const {
    const VkDebugUtilsLabelEXT label{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT, .pLabelName = name};
    begin_label_(commands, &label);
}

void Device::end_label(VkCommandBuffer commands) const { end_label_(commands); }

size_t Device::validation_message_count() const {
    const std::lock_guard lock(mutex_);
    return messages_.size();
}

void Device::check_validation(size_t heard) const {
    const std::lock_guard lock(mutex_);
    if (messages_.size() <= heard) return;
    throw Failure("validation said {} things; the first: {}", messages_.size() - heard, messages_[heard]);
}

uint64_t Device::timeout_ns() const {
    const char* given = std::getenv("LIGHTWALK_TIMEOUT_S");
    const std::string text = given && *given ? given : "60";
    char* end = nullptr;
    const double seconds = std::strtod(text.c_str(), &end);
    if (*end || !(seconds > 0))
        throw InputError("LIGHTWALK_TIMEOUT_S is '{}'; it takes a number of seconds above 0", text);
    // Upper bound of 30 years, so that nanoseconds plus the current time fit into 64 bits.
    return static_cast<uint64_t>(std::min(seconds, 1e9) * 1e9);
}

VkResult wait_for(const Device& device, const std::function<VkResult(uint64_t most_ns)>& wait) {
    const auto used_ns = [] {
        timespec used{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
        return 1'000'000'000 * static_cast<uint64_t>(used.tv_sec) + static_cast<uint64_t>(used.tv_nsec);
    };
    const uint64_t most = device.timeout_ns(), before = used_ns();
    const SharedLock::Unlocked others;
    VkResult answer = wait(most);
    for (int again = 1; again < 10 && answer == VK_TIMEOUT && device.software_paths && used_ns() - before < most;
         ++again)
        answer = wait(most);
    return answer;
}

}  // namespace lightwalk
