#include "common/gpu/fill.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace lightwalk {
namespace {

const Pipeline fill_numbers = compute({.shader = "common/fill.comp"});
const Pipeline fill_words = compute({.shader = "common/fill.comp", .macros = {{"OF_WORDS", "1"}}});

constexpr VkFormat word_formats[] = {VK_FORMAT_R32_UINT, VK_FORMAT_R32G32_UINT};
constexpr VkFormat number_formats[] = {
    VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R16G16_SFLOAT, VK_FORMAT_R32G32_SFLOAT,
    VK_FORMAT_R16_SFLOAT,          VK_FORMAT_R32_SFLOAT,          VK_FORMAT_D32_SFLOAT};

// Smaller ones cost less than the waits around a dispatch.
constexpr VkDeviceSize least_texels = 256 * 256;

constexpr Access fill_access{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT,
                             VK_IMAGE_LAYOUT_GENERAL, true};

bool is_among(std::span<const VkFormat> list, VkFormat format) { return std::ranges::find(list, format) != list.end(); }

bool is_written(const Device& device, VkFormat format) {
    VkFormatProperties3 all{.sType = VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_3};
    VkFormatProperties2 two{.sType = VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_2, .pNext = &all};
    vkGetPhysicalDeviceFormatProperties2(device.physical, format, &two);
    constexpr VkFormatFeatureFlags2 needed =
        VK_FORMAT_FEATURE_2_STORAGE_IMAGE_BIT | VK_FORMAT_FEATURE_2_STORAGE_WRITE_WITHOUT_FORMAT_BIT;
    return (all.optimalTilingFeatures & needed) == needed;
}

// In the device's ticks, the least of three: to clear a half4 target, and to fill as many bytes.
std::pair<uint64_t, uint64_t> clear_and_fill_ticks(Gpu& gpu) {
    constexpr uint32_t times = 3;
    Image image(gpu.device, {.name = "timed clear", .format = VK_FORMAT_R16G16B16A16_SFLOAT, .size = glm::uvec2(1024)});
    const ImageView target(image);
    const Buffer bytes(gpu.device, {.name = "timed fill", .bytes = byte_count(target)});
    Owned<VkQueryPool, vkDestroyQueryPool> stamps;
    const VkQueryPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                     .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                     .queryCount = 3 * times};
    check(vkCreateQueryPool(gpu.device.handle, &pool, nullptr, stamps.put(gpu.device.handle)), "vkCreateQueryPool");
    gpu.device.set_name(VK_OBJECT_TYPE_QUERY_POOL, reinterpret_cast<uint64_t>(VkQueryPool(stamps)), "timed clears");
    vkResetQueryPool(gpu.device.handle, stamps, 0, 3 * times);
    gpu.submit_now([&](VkCommandBuffer commands) {
        uint32_t next = 0;
        const auto stamp = [&] {
            constexpr VkPipelineStageFlags2 everything = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
            const VkMemoryBarrier2 wait{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                                        .srcStageMask = everything,
                                        .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
                                        .dstStageMask = everything,
                                        .dstAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT};
            const VkDependencyInfo info{
                .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &wait};
            vkCmdPipelineBarrier2(commands, &info);
            vkCmdWriteTimestamp2(commands, everything, stamps, next++);
        };
        barrier(commands, target,
                {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                 VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true});
        const VkRenderingAttachmentInfo cleared{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                                .imageView = target.handle(),
                                                .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                                .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                                .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
        const VkRenderingInfo rendering{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                                        .renderArea = {.extent = {image.desc.size.x, image.desc.size.y}},
                                        .layerCount = 1,
                                        .colorAttachmentCount = 1,
                                        .pColorAttachments = &cleared};
        for (uint32_t i = 0; i < times; ++i) {
            stamp();
            vkCmdBeginRendering(commands, &rendering);
            vkCmdEndRendering(commands);
            stamp();
            vkCmdFillBuffer(commands, bytes.handle, 0, VK_WHOLE_SIZE, 0);
            stamp();
        }
    });
    uint64_t at[3 * times] = {};
    check(vkGetQueryPoolResults(gpu.device.handle, stamps, 0, 3 * times, sizeof at, at, sizeof at[0],
                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "vkGetQueryPoolResults");
    std::pair<uint64_t, uint64_t> least{UINT64_MAX, UINT64_MAX};
    for (uint32_t i = 0; i < 3 * times; i += 3)
        least = {std::min(least.first, at[i + 1] - at[i]), std::min(least.second, at[i + 2] - at[i + 1])};
    return least;
}

}  // namespace

std::optional<bool>& fills_targets_always() {
    static std::optional<bool> always;
    return always;
}

// Where memory limits both, both take the same time; an H100's clear takes 30 times as long.
bool clears_slowly(Gpu& gpu) {
    const auto [clear_ticks, fill_ticks] = clear_and_fill_ticks(gpu);
    return clear_ticks > 4 * std::max<uint64_t>(fill_ticks, 1);
}

bool fills_targets(Gpu& gpu) {
    if (fills_targets_always()) return *fills_targets_always();
    if (gpu.device.software()) return false;
    static std::mutex mutex;
    static std::map<std::pair<uint32_t, uint32_t>, bool> known;
    const std::lock_guard lock(mutex);
    const auto [found, is_new] =
        known.try_emplace({gpu.device.properties.vendorID, gpu.device.properties.deviceID}, false);
    if (is_new) {
        found->second = clears_slowly(gpu);
        if (found->second)  // before a picture waits for them
            for (const Pipeline* one : {&fill_numbers, &fill_words}) gpu.pipelines.get(*one, {}, {});
    }
    return found->second;
}

bool can_fill(const Device& device, const Attachment& target, uint32_t layers) {
    if (!target.view || target.load != Attachment::Load::clear || target.resolve_into) return false;
    const Image::Desc& desc = target.view.image->desc;
    const glm::uvec3 size = target.view.size();
    return desc.samples == 1 && !target.view.is_volume() && target.view.format == VK_FORMAT_UNDEFINED &&
           VkDeviceSize(size.x) * size.y * layers >= least_texels &&
           (is_among(number_formats, desc.format) || is_among(word_formats, desc.format)) &&
           is_written(device, desc.format);
}

RasterTargets fill_targets(Frame& frame, Commands& commands, const RasterTargets& targets) {
    RasterTargets kept = targets;
    std::vector<std::pair<ImageView, glm::vec4>> all;
    const auto add = [&](Attachment& target, const glm::vec4& value) {
        if (!can_fill(frame.gpu.device, target, targets.layers)) return;
        target.load = Attachment::Load::keep;
        const ImageView mip = target.view.mip(0);
        for (uint32_t layer = 0; layer < targets.layers; ++layer)
            all.emplace_back(mip.type == VK_IMAGE_VIEW_TYPE_2D ? mip : mip.layer(layer), value);
    };
    for (Attachment& target : kept.color) add(target, target.color);
    add(kept.depth, glm::vec4(kept.depth.depth));
    Barriers barriers;
    for (const auto& [view, value] : all) barriers.add(view, fill_access);
    barriers.record(commands);
    for (const auto& [view, value] : all) {
        const bool of_words = is_among(word_formats, view.image->desc.format);
        const BuiltPipeline* const pipeline = frame.gpu.pipelines.get(of_words ? fill_words : fill_numbers, {}, {});
        if (!pipeline) continue;  // being edited
        commands.bind_pipeline(VK_PIPELINE_BIND_POINT_COMPUTE, pipeline->handle);
        if (frame.gpu.device.hides_blocks) commands.push_constant(pipeline->layout, VK_SHADER_STAGE_ALL, 0);
        const VkDescriptorImageInfo image{.imageView = view.handle(), .imageLayout = fill_access.layout};
        const VkDescriptorBufferInfo block = frame.copy_to_arena(std::as_bytes(std::span(&value, 1)));
        std::vector<VkWriteDescriptorSet> writes;
        for (const Binding& binding : pipeline->bindings)
            writes.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                              .dstBinding = binding.number,
                              .descriptorCount = 1,
                              .descriptorType = binding.type,
                              .pImageInfo = &image,
                              .pBufferInfo = &block});
        if (pipeline->pushes)
            commands.push_descriptors(VK_PIPELINE_BIND_POINT_COMPUTE, pipeline->layout, writes);
        else
            commands.bind_descriptor_set(VK_PIPELINE_BIND_POINT_COMPUTE, pipeline->layout,
                                         frame.descriptor_set(*pipeline, writes));
        const glm::uvec2 size(view.size());
        commands.dispatch(glm::uvec3((size + 31u) / 32u, 1));
    }
    return kept;
}

}  // namespace lightwalk
