// Part of 00_descriptors.cpp: device, images, pipeline, submission and clocks, as docs/vulkan.md explains them.
// clang-format off
#pragma once
#include <vulkan/vulkan.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

constexpr uint32_t table_entries = 2048;  // as in 00_descriptors.frag
constexpr VkExtent2D size{400, 250};  // of the picture, a pixel for each of 100,000 draws
constexpr VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;
constexpr VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, VK_REMAINING_ARRAY_LAYERS};

VkInstance instance;
VkPhysicalDevice physical;
VkDevice device;
VkQueue queue;
uint32_t family = 0;
VkPhysicalDeviceVulkan12Properties about_driver{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES};
VkPhysicalDeviceProperties2 about{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &about_driver};
bool has_push = false, has_table = false;
std::vector<std::function<void()>> cleanup;  // run in the reverse order of creation

void check(VkResult result, const char* call) {
    if (result != VK_SUCCESS) throw std::runtime_error(std::string(call) + " gave " + std::to_string(result));
}

template <class Info, class Handle>  // any object of a device, destroyed at the end
Handle make(VkResult (*create)(VkDevice, const Info*, const VkAllocationCallbacks*, Handle*),
            void (*destroy)(VkDevice, Handle, const VkAllocationCallbacks*), const Info& info) {
    Handle handle;
    check(create(device, &info, nullptr, &handle), "a call that creates an object");
    cleanup.push_back([=] { destroy(device, handle, nullptr); });
    return handle;
}

void make_device() {
    const VkApplicationInfo app{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_3};
    const VkInstanceCreateInfo create{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &app};
    check(vkCreateInstance(&create, nullptr, &instance), "vkCreateInstance");
    cleanup.push_back([] { vkDestroyInstance(instance, nullptr); });
    VkPhysicalDevice found[8];
    uint32_t count = 8;
    vkEnumeratePhysicalDevices(instance, &count, found);
    if (count == 0) throw std::runtime_error("no driver of Vulkan");
    for (uint32_t i = 0; i < count && (i == 0 || about.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU); ++i)
        vkGetPhysicalDeviceProperties2(physical = found[i], &about);  // the first that is no processor, if there is one
    uint32_t families = 16;
    VkQueueFamilyProperties of[16];
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &families, of);
    while (family < families && !(of[family].queueFlags & VK_QUEUE_GRAPHICS_BIT)) ++family;

    // [features]
    VkPhysicalDeviceVulkan12Features can{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    VkPhysicalDeviceFeatures2 core{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, .pNext = &can};
    vkGetPhysicalDeviceFeatures2(physical, &core);
    const VkPhysicalDeviceLimits& limits = about.properties.limits;
    has_table = can.shaderSampledImageArrayNonUniformIndexing && can.descriptorBindingPartiallyBound &&
        std::min({limits.maxPerStageDescriptorSampledImages, limits.maxPerStageDescriptorSamplers,
                  limits.maxPerStageResources, limits.maxDescriptorSetSampledImages}) >= table_entries + 2;
    // [/features]
    count = 1024;
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, extensions.data());
    for (const VkExtensionProperties& one : extensions)
        has_push |= std::strcmp(one.extensionName, VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME) == 0;
    const char* push = VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME;
    VkPhysicalDeviceVulkan13Features modern{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
        .synchronization2 = VK_TRUE, .dynamicRendering = VK_TRUE};
    const VkPhysicalDeviceVulkan12Features wanted{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES,
        .pNext = &modern, .shaderSampledImageArrayNonUniformIndexing = has_table,
        .descriptorBindingPartiallyBound = has_table};
    const VkPhysicalDeviceFeatures old{.multiDrawIndirect = VK_TRUE, .drawIndirectFirstInstance = VK_TRUE,
        .shaderSampledImageArrayDynamicIndexing = has_table};
    const float priority = 1;
    const VkDeviceQueueCreateInfo queues{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
        .queueFamilyIndex = family, .queueCount = 1, .pQueuePriorities = &priority};
    const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .pNext = &wanted,
        .queueCreateInfoCount = 1, .pQueueCreateInfos = &queues, .enabledExtensionCount = has_push ? 1u : 0u,
        .ppEnabledExtensionNames = &push, .pEnabledFeatures = &old};
    check(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
    cleanup.push_back([] { vkDestroyDevice(device, nullptr); });
    vkGetDeviceQueue(device, family, 0, &queue);
}

VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkDeviceSize bytes, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    uint32_t type = 0;
    while (!(needs.memoryTypeBits >> type & 1 && (memory.memoryTypes[type].propertyFlags & wanted) == wanted)) ++type;
    return make(vkAllocateMemory, vkFreeMemory, {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
        .allocationSize = bytes, .memoryTypeIndex = type});
}

struct Buffer { VkBuffer handle; std::byte* bytes; };

Buffer make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage) {
    Buffer made{make(vkCreateBuffer, vkDestroyBuffer, {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = bytes,
        .usage = usage}), nullptr};
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device, made.handle, &needs);
    const VkDeviceMemory memory =
        allocate(needs, needs.size, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    check(vkBindBufferMemory(device, made.handle, memory, 0), "vkBindBufferMemory");
    check(vkMapMemory(device, memory, 0, bytes, 0, reinterpret_cast<void**>(&made.bytes)), "vkMapMemory");
    return made;
}

struct Image { VkImage handle; VkImageView view; };

std::vector<Image> make_images(uint32_t count, VkExtent2D extent, uint32_t layers, VkImageUsageFlags usage) {
    std::vector<Image> made(count);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    for (uint32_t i = 0; i < count; ++i) {
        made[i].handle = make(vkCreateImage, vkDestroyImage, {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
            .imageType = VK_IMAGE_TYPE_2D, .format = format, .extent = {extent.width, extent.height, 1}, .mipLevels = 1,
            .arrayLayers = layers, .samples = VK_SAMPLE_COUNT_1_BIT, .usage = usage});
        VkMemoryRequirements needs;
        vkGetImageMemoryRequirements(device, made[i].handle, &needs);
        const VkDeviceSize bytes = (needs.size + needs.alignment - 1) / needs.alignment * needs.alignment;
        if (i == 0) memory = allocate(needs, count * bytes, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
        check(vkBindImageMemory(device, made[i].handle, memory, i * bytes), "vkBindImageMemory");
        made[i].view = make(vkCreateImageView, vkDestroyImageView, {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
            .image = made[i].handle, .viewType = layers > 1 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D,
            .format = format, .subresourceRange = whole});
    }
    return made;
}

void barrier(VkCommandBuffer commands, VkImage image, VkImageLayout before, VkImageLayout after) {
    const VkImageMemoryBarrier2 one{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
        .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
        .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
        .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
        .oldLayout = before, .newLayout = after, .image = image, .subresourceRange = whole};
    const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1,
        .pImageMemoryBarriers = &one};
    vkCmdPipelineBarrier2(commands, &info);
}

VkPipeline make_pipeline(VkPipelineLayout layout, const std::string& shaders, const std::string& fragment_shader) {
    VkPipelineShaderStageCreateInfo stages[2];
    for (const bool fragment : {false, true}) {
        const std::string file = shaders + "/00_descriptors." + (fragment ? fragment_shader : "vert") + ".spv";
        std::ifstream stream(file, std::ios::binary);
        const std::string code(std::istreambuf_iterator<char>(stream), {});
        if (code.empty()) throw std::runtime_error("no shader " + file);
        stages[fragment] = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
            .stage = fragment ? VK_SHADER_STAGE_FRAGMENT_BIT : VK_SHADER_STAGE_VERTEX_BIT,
            .module = make(vkCreateShaderModule, vkDestroyShaderModule, {
                .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = code.size(),
                .pCode = reinterpret_cast<const uint32_t*>(code.data())}),
            .pName = "main"};
    }
    const VkPipelineVertexInputStateCreateInfo input{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    const VkPipelineInputAssemblyStateCreateInfo assembly{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP};
    const VkViewport viewport{0, 0, size.width, size.height, 0, 1};
    const VkRect2D scissor{{}, size};
    const VkPipelineViewportStateCreateInfo view{.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1, .pViewports = &viewport, .scissorCount = 1, .pScissors = &scissor};
    const VkPipelineRasterizationStateCreateInfo raster{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1};
    const VkPipelineMultisampleStateCreateInfo samples{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
    const VkPipelineColorBlendAttachmentState all{.colorWriteMask = 0xf};
    const VkPipelineColorBlendStateCreateInfo blend{.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = 1, .pAttachments = &all};
    const VkPipelineRenderingCreateInfo target{.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = 1, .pColorAttachmentFormats = &format};
    const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, .pNext = &target,
        .stageCount = 2, .pStages = stages, .pVertexInputState = &input, .pInputAssemblyState = &assembly,
        .pViewportState = &view, .pRasterizationState = &raster, .pMultisampleState = &samples,
        .pColorBlendState = &blend, .layout = layout};
    VkPipeline pipeline;
    check(vkCreateGraphicsPipelines(device, nullptr, 1, &info, nullptr, &pipeline), "vkCreateGraphicsPipelines");
    cleanup.push_back([=] { vkDestroyPipeline(device, pipeline, nullptr); });
    return pipeline;
}

VkCommandBuffer make_commands() {
    const VkCommandPool pool = make(vkCreateCommandPool, vkDestroyCommandPool, {
        .sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
        .queueFamilyIndex = family});
    const VkCommandBufferAllocateInfo one{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, .commandPool = pool,
        .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY, .commandBufferCount = 1};
    VkCommandBuffer commands;
    check(vkAllocateCommandBuffers(device, &one, &commands), "vkAllocateCommandBuffers");
    return commands;
}

void begin(VkCommandBuffer commands) {
    const VkCommandBufferBeginInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    check(vkBeginCommandBuffer(commands, &info), "vkBeginCommandBuffer");
}

void submit(VkCommandBuffer commands, VkFence ended) {  // and waits for the GPU
    const VkCommandBufferSubmitInfo buffer{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
        .commandBuffer = commands};
    const VkSubmitInfo2 info{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2, .commandBufferInfoCount = 1,
        .pCommandBufferInfos = &buffer};
    check(vkQueueSubmit2(queue, 1, &info, ended), "vkQueueSubmit2");
    check(vkWaitForFences(device, 1, &ended, VK_TRUE, UINT64_MAX), "vkWaitForFences");
    check(vkResetFences(device, 1, &ended), "vkResetFences");
}

using ColorOf = std::function<uint32_t(uint32_t)>;  // of a layer, 8 bits a channel, red lowest

void fill(VkCommandBuffer commands, VkFence ended, const Image& image, uint32_t layers, const ColorOf& color_of) {
    begin(commands);
    barrier(commands, image.handle, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    for (uint32_t i = 0; i < layers; ++i) {
        VkClearColorValue color;
        for (int k = 0; k < 4; ++k) color.float32[k] = static_cast<float>(color_of(i) >> 8 * k & 255) / 255;
        const VkImageSubresourceRange layer{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, i, 1};
        vkCmdClearColorImage(commands, image.handle, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &color, 1, &layer);
    }
    barrier(commands, image.handle, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    submit(commands, ended);
}

void begin_rendering(VkCommandBuffer commands, const Image& target) {
    barrier(commands, target.handle, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    const VkRenderingAttachmentInfo color{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
        .imageView = target.view, .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
        .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR, .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
    const VkRenderingInfo rendering{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO, .renderArea = {{}, size},
        .layerCount = 1, .colorAttachmentCount = 1, .pColorAttachments = &color};
    vkCmdBeginRendering(commands, &rendering);
}

void read_back(VkCommandBuffer commands, const Image& target, const Buffer& copy) {
    barrier(commands, target.handle, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    const VkBufferImageCopy all{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
        .imageExtent = {size.width, size.height, 1}};
    vkCmdCopyImageToBuffer(commands, target.handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, copy.handle, 1, &all);
    const VkMemoryBarrier2 to_cpu{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
        .srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT, .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
        .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT, .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT};
    const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1,
        .pMemoryBarriers = &to_cpu};
    vkCmdPipelineBarrier2(commands, &info);
}

double gpu_ms(VkQueryPool times) {
    uint64_t counts[2];
    check(vkGetQueryPoolResults(device, times, 0, 2, sizeof counts, counts, sizeof counts[0], VK_QUERY_RESULT_64_BIT),
          "vkGetQueryPoolResults");
    return 1e-6 * about.properties.limits.timestampPeriod * static_cast<double>(counts[1] - counts[0]);
}

double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::array<double, 3> quartiles(std::vector<double> of) {  // the median, the lower and the upper one
    std::sort(of.begin(), of.end());
    return {of[(of.size() - 1) / 2], of[(of.size() - 1) / 4], of[(of.size() - 1) * 3 / 4]};
}
