// A triangle in Vulkan 1.3 without a framework: into a picture file, or into a window.
//     00_vulkan SHADERS picture.ppm     draws once, reads the picture back, writes it
//     00_vulkan SHADERS window [N]      opens a window; with N, closes it after N frames
//     00_vulkan SHADERS time [N]        draws N times in a frame and prints how long the GPU takes
// SHADERS is the folder with 00_vulkan.vert.spv and 00_vulkan.frag.spv.
// Exit code 1: a failure, or a message of the validation layer.
// Several fields a line keep the structs of Vulkan short:
// clang-format off
#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

constexpr VkExtent2D picture_size{256, 256};
constexpr VkFormat picture_format = VK_FORMAT_R8G8B8A8_SRGB;  // the GPU encodes linear light as sRGB

struct Vertex {  // as in 00_vulkan.vert
    float position[4], color[4];
};
constexpr Vertex triangle[] = {{{0, -0.8f, 0, 1}, {1, 0, 0, 1}}, {{-0.8f, 0.6f, 0, 1}, {0, 1, 0, 1}},
                               {{0.8f, 0.6f, 0, 1}, {0, 0, 1, 1}}};

GLFWwindow* window = nullptr;
VkInstance instance;
VkSurfaceKHR surface = VK_NULL_HANDLE;
VkPhysicalDevice physical;
VkDevice device;
VkQueue queue;
uint32_t family = 0;
int messages = 0;
std::vector<std::function<void()>> cleanup;  // run in the reverse order of creation

void check(VkResult result, const char* call) {
    if (result != VK_SUCCESS) throw std::runtime_error(std::string(call) + " gave " + std::to_string(result));
}

template <class Function>
Function extension(const char* name) {  // a function of an extension, which the loader does not export
    return reinterpret_cast<Function>(vkGetInstanceProcAddr(instance, name));
}

// [instance]
VKAPI_ATTR VkBool32 VKAPI_CALL hear(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                    const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
    ++messages;
    std::fprintf(stderr, "%s\n\n", data->pMessage);
    return VK_FALSE;
}

void make_instance() {
    std::vector<const char*> extensions{VK_EXT_DEBUG_UTILS_EXTENSION_NAME};
    uint32_t count = 0;
    const char** of_window = window ? glfwGetRequiredInstanceExtensions(&count) : nullptr;
    extensions.insert(extensions.end(), of_window, of_window + count);
    const char* layer = "VK_LAYER_KHRONOS_validation";
    const VkValidationFeatureEnableEXT enable = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    const VkValidationFeaturesEXT validation{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
        .enabledValidationFeatureCount = 1, .pEnabledValidationFeatures = &enable};
    const VkApplicationInfo app{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_3};
    const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pNext = &validation,
        .pApplicationInfo = &app, .enabledLayerCount = 1, .ppEnabledLayerNames = &layer,
        .enabledExtensionCount = static_cast<uint32_t>(extensions.size()),
        .ppEnabledExtensionNames = extensions.data()};
    check(vkCreateInstance(&info, nullptr, &instance), "vkCreateInstance");
    cleanup.push_back([] { vkDestroyInstance(instance, nullptr); });

    const VkDebugUtilsMessengerCreateInfoEXT listen{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
        .messageSeverity =
            VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
        .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT, .pfnUserCallback = hear};
    VkDebugUtilsMessengerEXT messenger;
    const auto create = extension<PFN_vkCreateDebugUtilsMessengerEXT>("vkCreateDebugUtilsMessengerEXT");
    check(create(instance, &listen, nullptr, &messenger), "vkCreateDebugUtilsMessengerEXT");
    const auto destroy = extension<PFN_vkDestroyDebugUtilsMessengerEXT>("vkDestroyDebugUtilsMessengerEXT");
    cleanup.push_back([=] { destroy(instance, messenger, nullptr); });
}
// [/instance]

// [device]
void make_device() {
    uint32_t count = 1;
    const VkResult found = vkEnumeratePhysicalDevices(instance, &count, &physical);  // the first of them
    if (found != VK_INCOMPLETE) check(found, "vkEnumeratePhysicalDevices");
    if (count == 0) throw std::runtime_error("no driver of Vulkan");

    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    for (family = 0; family < count; ++family) {
        VkBool32 shows = VK_TRUE;
        if (surface) vkGetPhysicalDeviceSurfaceSupportKHR(physical, family, surface, &shows);
        if (shows && families[family].queueFlags & VK_QUEUE_GRAPHICS_BIT) break;
    }
    if (family == count) throw std::runtime_error("no queue that draws");

    const float priority = 1;
    const VkDeviceQueueCreateInfo queues{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
        .queueFamilyIndex = family, .queueCount = 1, .pQueuePriorities = &priority};
    const VkPhysicalDeviceVulkan13Features features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
        .synchronization2 = VK_TRUE, .dynamicRendering = VK_TRUE};
    const char* extensions[] = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME, VK_KHR_SWAPCHAIN_EXTENSION_NAME};
    const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .pNext = &features,
        .queueCreateInfoCount = 1, .pQueueCreateInfos = &queues,
        .enabledExtensionCount = window ? 2u : 1u, .ppEnabledExtensionNames = extensions};
    check(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
    cleanup.push_back([] { vkDestroyDevice(device, nullptr); });
    vkGetDeviceQueue(device, family, 0, &queue);
}
// [/device]

// [name]
template <class Handle>
void name(VkObjectType type, Handle handle, const char* text) {
    const VkDebugUtilsObjectNameInfoEXT info{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
        .objectType = type, .objectHandle = reinterpret_cast<uint64_t>(handle), .pObjectName = text};
    extension<PFN_vkSetDebugUtilsObjectNameEXT>("vkSetDebugUtilsObjectNameEXT")(device, &info);
}
// [/name]

// [memory]
VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    uint32_t type = 0;
    const auto suits = [&] {
        return needs.memoryTypeBits >> type & 1 && (memory.memoryTypes[type].propertyFlags & wanted) == wanted;
    };
    while (type < memory.memoryTypeCount && !suits()) ++type;
    if (type == memory.memoryTypeCount) throw std::runtime_error("no memory of the kind wanted");
    const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needs.size,
        .memoryTypeIndex = type};
    VkDeviceMemory result;
    check(vkAllocateMemory(device, &info, nullptr, &result), "vkAllocateMemory");
    cleanup.push_back([=] { vkFreeMemory(device, result, nullptr); });
    return result;
}

struct Buffer { VkBuffer handle; void* bytes; };  // in memory that the CPU can address as well

Buffer make_buffer(const char* label, VkDeviceSize size, VkBufferUsageFlags usage) {
    const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = usage};
    Buffer buffer;
    check(vkCreateBuffer(device, &info, nullptr, &buffer.handle), "vkCreateBuffer");
    name(VK_OBJECT_TYPE_BUFFER, buffer.handle, label);
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device, buffer.handle, &needs);
    const VkDeviceMemory memory =
        allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    cleanup.push_back([=] { vkDestroyBuffer(device, buffer.handle, nullptr); });
    check(vkBindBufferMemory(device, buffer.handle, memory, 0), "vkBindBufferMemory");
    check(vkMapMemory(device, memory, 0, size, 0, &buffer.bytes), "vkMapMemory");
    return buffer;
}
// [/memory]

// [image]
VkImage make_picture() {
    const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO, .imageType = VK_IMAGE_TYPE_2D,
        .format = picture_format, .extent = {picture_size.width, picture_size.height, 1}, .mipLevels = 1,
        .arrayLayers = 1, .samples = VK_SAMPLE_COUNT_1_BIT,
        .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT};
    VkImage image;
    check(vkCreateImage(device, &info, nullptr, &image), "vkCreateImage");
    name(VK_OBJECT_TYPE_IMAGE, image, "picture");
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device, image, &needs);
    const VkDeviceMemory memory = allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    cleanup.push_back([=] { vkDestroyImage(device, image, nullptr); });
    check(vkBindImageMemory(device, image, memory, 0), "vkBindImageMemory");
    return image;
}

VkImageView make_view(VkImage image, VkFormat format) {
    const VkImageViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO, .image = image,
        .viewType = VK_IMAGE_VIEW_TYPE_2D, .format = format,
        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    VkImageView view;
    check(vkCreateImageView(device, &info, nullptr, &view), "vkCreateImageView");
    return view;
}
// [/image]

// [pipeline]
VkShaderModule make_shader(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string code(std::istreambuf_iterator<char>(stream), {});
    if (code.empty()) throw std::runtime_error("no shader " + file);
    const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = code.size(),
        .pCode = reinterpret_cast<const uint32_t*>(code.data())};
    VkShaderModule shader;
    check(vkCreateShaderModule(device, &info, nullptr, &shader), "vkCreateShaderModule");
    return shader;
}

struct Pipeline { VkPipelineLayout layout; VkPipeline handle; };  // the layout lists the resources of its shaders

Pipeline make_pipeline(const std::string& shaders, VkFormat target) {
    Pipeline made;
    const VkDescriptorSetLayoutBinding vertices{.binding = 0, .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
        .descriptorCount = 1, .stageFlags = VK_SHADER_STAGE_VERTEX_BIT};
    const VkDescriptorSetLayoutCreateInfo set{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR, .bindingCount = 1, .pBindings = &vertices};
    VkDescriptorSetLayout set_layout;
    check(vkCreateDescriptorSetLayout(device, &set, nullptr, &set_layout), "vkCreateDescriptorSetLayout");
    const VkPushConstantRange angle{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(float)};
    const VkPipelineLayoutCreateInfo layout{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO, .setLayoutCount = 1,
        .pSetLayouts = &set_layout, .pushConstantRangeCount = 1, .pPushConstantRanges = &angle};
    check(vkCreatePipelineLayout(device, &layout, nullptr, &made.layout), "vkCreatePipelineLayout");

    const VkShaderModule vertex = make_shader(shaders + "/00_vulkan.vert.spv");
    const VkShaderModule fragment = make_shader(shaders + "/00_vulkan.frag.spv");
    const VkPipelineShaderStageCreateInfo stages[] = {
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, .stage = VK_SHADER_STAGE_VERTEX_BIT,
         .module = vertex, .pName = "main"},
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, .stage = VK_SHADER_STAGE_FRAGMENT_BIT,
         .module = fragment, .pName = "main"}};
    const VkPipelineVertexInputStateCreateInfo input{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    const VkPipelineInputAssemblyStateCreateInfo assembly{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    const VkPipelineViewportStateCreateInfo viewport{.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1, .scissorCount = 1};
    const VkPipelineRasterizationStateCreateInfo raster{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1};
    const VkPipelineMultisampleStateCreateInfo samples{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
    const VkPipelineColorBlendAttachmentState write_all{.colorWriteMask = 0xf};
    const VkPipelineColorBlendStateCreateInfo blend{.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = 1, .pAttachments = &write_all};
    const VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic{.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = 2, .pDynamicStates = states};
    const VkPipelineRenderingCreateInfo rendering{.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = 1, .pColorAttachmentFormats = &target};
    const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
        .pNext = &rendering, .stageCount = 2, .pStages = stages, .pVertexInputState = &input,
        .pInputAssemblyState = &assembly, .pViewportState = &viewport, .pRasterizationState = &raster,
        .pMultisampleState = &samples, .pColorBlendState = &blend, .pDynamicState = &dynamic, .layout = made.layout};
    check(vkCreateGraphicsPipelines(device, nullptr, 1, &info, nullptr, &made.handle), "vkCreateGraphicsPipelines");
    vkDestroyShaderModule(device, vertex, nullptr);
    vkDestroyShaderModule(device, fragment, nullptr);
    cleanup.push_back([=] {
        vkDestroyPipeline(device, made.handle, nullptr);
        vkDestroyPipelineLayout(device, made.layout, nullptr);
        vkDestroyDescriptorSetLayout(device, set_layout, nullptr);
    });
    return made;
}
// [/pipeline]

// [commands]
VkCommandBuffer make_commands() {
    const VkCommandPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
        .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT, .queueFamilyIndex = family};
    VkCommandPool pool;
    check(vkCreateCommandPool(device, &info, nullptr, &pool), "vkCreateCommandPool");
    cleanup.push_back([=] { vkDestroyCommandPool(device, pool, nullptr); });
    const VkCommandBufferAllocateInfo one{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, .commandPool = pool,
        .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY, .commandBufferCount = 1};
    VkCommandBuffer commands;
    check(vkAllocateCommandBuffers(device, &one, &commands), "vkAllocateCommandBuffers");
    return commands;
}

void begin(VkCommandBuffer commands) {
    const VkCommandBufferBeginInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
        .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    check(vkBeginCommandBuffer(commands, &info), "vkBeginCommandBuffer");
}
// [/commands]

// [barrier]
struct Use { VkPipelineStageFlags2 stage; VkAccessFlags2 access; VkImageLayout layout; };
constexpr Use new_image{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED};
constexpr Use drawn_into{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                         VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
constexpr Use copied_from{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                          VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};

void barrier(VkCommandBuffer commands, VkImage image, const Use& before, const Use& after) {
    const VkImageMemoryBarrier2 one{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
        .srcStageMask = before.stage, .srcAccessMask = before.access,
        .dstStageMask = after.stage, .dstAccessMask = after.access,
        .oldLayout = before.layout, .newLayout = after.layout,
        .image = image, .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1,
        .pImageMemoryBarriers = &one};
    vkCmdPipelineBarrier2(commands, &info);
}
// [/barrier]

// [draw]
void draw(VkCommandBuffer commands, const Pipeline& pipeline, VkBuffer vertices, VkImageView target, VkExtent2D size,
          float angle_rad) {
    const VkRenderingAttachmentInfo color{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO, .imageView = target,
        .imageLayout = drawn_into.layout, .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
        .storeOp = VK_ATTACHMENT_STORE_OP_STORE, .clearValue = {.color = {{0.02f, 0.02f, 0.03f, 1}}}};
    const VkRenderingInfo rendering{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO, .renderArea = {{0, 0}, size},
        .layerCount = 1, .colorAttachmentCount = 1, .pColorAttachments = &color};
    vkCmdBeginRendering(commands, &rendering);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.handle);
    const VkDescriptorBufferInfo buffer{vertices, 0, VK_WHOLE_SIZE};
    const VkWriteDescriptorSet binding{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET, .dstBinding = 0,
        .descriptorCount = 1, .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .pBufferInfo = &buffer};
    static const auto push = extension<PFN_vkCmdPushDescriptorSetKHR>("vkCmdPushDescriptorSetKHR");
    push(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.layout, 0, 1, &binding);
    vkCmdPushConstants(commands, pipeline.layout, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(float), &angle_rad);
    const VkViewport viewport{0, 0, static_cast<float>(size.width), static_cast<float>(size.height), 0, 1};
    const VkRect2D scissor{{0, 0}, size};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
}
// [/draw]

// [submit]
void submit(VkCommandBuffer commands, VkSemaphore wait = VK_NULL_HANDLE, VkSemaphore signal = VK_NULL_HANDLE,
            VkFence ended = VK_NULL_HANDLE) {
    const VkCommandBufferSubmitInfo buffer{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
        .commandBuffer = commands};
    const VkSemaphoreSubmitInfo before{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO, .semaphore = wait,
        .stageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT};
    const VkSemaphoreSubmitInfo after{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO, .semaphore = signal,
        .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
    const VkSubmitInfo2 info{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
        .waitSemaphoreInfoCount = wait ? 1u : 0u, .pWaitSemaphoreInfos = &before,
        .commandBufferInfoCount = 1, .pCommandBufferInfos = &buffer,
        .signalSemaphoreInfoCount = signal ? 1u : 0u, .pSignalSemaphoreInfos = &after};
    check(vkQueueSubmit2(queue, 1, &info, ended), "vkQueueSubmit2");
}
// [/submit]

// [picture]
void write_picture(const std::string& shaders, VkBuffer vertices, const char* file) {
    const VkImage image = make_picture();
    const VkImageView view = make_view(image, picture_format);
    cleanup.push_back([=] { vkDestroyImageView(device, view, nullptr); });
    const size_t pixels = picture_size.width * picture_size.height;
    const Buffer copy = make_buffer("copy of the picture", 4 * pixels, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    const Pipeline pipeline = make_pipeline(shaders, picture_format);
    const VkCommandBuffer commands = make_commands();

    begin(commands);
    barrier(commands, image, new_image, drawn_into);
    draw(commands, pipeline, vertices, view, picture_size, 0);
    barrier(commands, image, drawn_into, copied_from);
    const VkBufferImageCopy all{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
        .imageExtent = {picture_size.width, picture_size.height, 1}};
    vkCmdCopyImageToBuffer(commands, image, copied_from.layout, copy.handle, 1, &all);
    const VkMemoryBarrier2 to_cpu{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
        .srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT, .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
        .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT, .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT};
    const VkDependencyInfo read_back{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1,
        .pMemoryBarriers = &to_cpu};
    vkCmdPipelineBarrier2(commands, &read_back);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");

    submit(commands);
    check(vkQueueWaitIdle(queue), "vkQueueWaitIdle");
    std::ofstream out(file, std::ios::binary);
    out << "P6 " << picture_size.width << ' ' << picture_size.height << " 255\n";
    for (size_t i = 0; i < pixels; ++i) out.write(static_cast<const char*>(copy.bytes) + 4 * i, 3);
    if (!out.flush()) throw std::runtime_error(std::string(file) + " cannot be written");
}
// [/picture]

#include "00_window.h"  // step two: the same triangle in a window
#include "00_timing.h"  // step three: its time

int main(int argc, char** argv) try {
    if (argc < 3 || argc > 4) throw std::runtime_error("usage: 00_vulkan SHADERS picture.ppm|window|time [N]");
    if (std::strcmp(argv[2], "window") == 0) open_window();
    make_instance();
    if (window) make_surface();
    make_device();
    const Buffer vertices = make_buffer("vertices", sizeof triangle, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    std::memcpy(vertices.bytes, triangle, sizeof triangle);
    if (window) show_window(argv[1], vertices.handle, argc == 4 ? std::atoi(argv[3]) : 0);
    else if (std::strcmp(argv[2], "time") == 0)
        time_passes(argv[1], vertices.handle, argc == 4 ? std::atoi(argv[3]) : 1);
    else write_picture(argv[1], vertices.handle, argv[2]);
    vkDeviceWaitIdle(device);
    for (; !cleanup.empty(); cleanup.pop_back()) cleanup.back()();
    return messages ? 1 : 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
}
