#include "common/gpu/frame.h"

#include <cstring>
#include <utility>

#include "common/base/error.h"

namespace lightwalk {
namespace {

constexpr uint32_t max_passes = 256;
constexpr VkDeviceSize arena_bytes = 1 << 20;
constexpr VkPipelineStageFlags2 raster_stages =
    VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;

Access shader_access(bool compute, bool reads, bool writes, bool buffer) {
    Access access{.stages = compute ? VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT : raster_stages,
                  .access = VK_ACCESS_2_NONE,
                  .layout = writes ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                  .writes = writes};
    if (reads) access.access |= VK_ACCESS_2_SHADER_READ_BIT;
    // A storage image is often read to be written; saying so costs nothing.
    if (writes) access.access |= VK_ACCESS_2_SHADER_WRITE_BIT | VK_ACCESS_2_SHADER_READ_BIT;
    if (buffer && reads) {
        access.stages |= VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT;
        access.access |= VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT;
        if (!compute) {
            access.stages |= VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT;
            access.access |= VK_ACCESS_2_INDEX_READ_BIT;
        }
    }
    return access;
}

bool contains(const std::vector<Resource>& list, const Resource& wanted) {
    for (const Resource& r : list)
        if (r.image == wanted.image && r.buffer == wanted.buffer) return true;
    return false;
}

void shader_barriers(VkCommandBuffer commands, bool compute, const std::vector<Resource>& reads,
                     const std::vector<Resource>& writes) {
    const auto one = [&](const Resource& r, bool read, bool write) {
        if (r.image && !r.image->constant) barrier(commands, *r.image, shader_access(compute, read, write, false));
        if (r.buffer && !r.buffer->constant) barrier(commands, *r.buffer, shader_access(compute, read, write, true));
    };
    for (const Resource& r : reads)
        if (!contains(writes, r)) one(r, true, false);
    for (const Resource& w : writes) one(w, contains(reads, w), true);
}

// All that is given to a pass. Two of a kind would share their names in its shaders.
std::vector<const Given*> expand(const std::vector<With>& with, const Given* root) {
    std::vector<const Given*> all;
    if (root) all.push_back(root);
    for (const Given& given : with) given.expand(all);
    for (size_t i = 0; i < all.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            if (all[i] != all[j] && all[i]->kind() == all[j]->kind())
                throw Failure("a pass is given two modules of the kind '" + all[i]->kind() + "'; it takes one");
    return all;
}

std::vector<Resource> with_given(std::vector<Resource> reads, const std::vector<const Given*>& given) {
    for (const Given* one : given)
        for (const Resource& resource : one->reads()) reads.push_back(resource);
    return reads;
}

VkRenderingAttachmentInfo attachment(const Image& image, bool keep, const VkClearValue& clear) {
    return {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
            .imageView = image.desc.mips > 1 ? image.mip_view(0) : image.view,
            .imageLayout =
                image.is_depth() ? VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL : VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
            .loadOp = keep ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR,
            .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
            .clearValue = clear};
}

}  // namespace

Frame::Frame(Gpu& owner) : gpu(owner) {
    const VkDevice device = gpu.device.handle;
    const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                            .queueFamilyIndex = gpu.device.queue_family};
    check(vkCreateCommandPool(device, &pool_info, nullptr, &pool_), "vkCreateCommandPool");
    const VkQueryPoolCreateInfo query_info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                           .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                           .queryCount = 2 * max_passes};
    check(vkCreateQueryPool(device, &query_info, nullptr, &queries_), "vkCreateQueryPool");
    const VkSemaphoreTypeCreateInfo type{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO,
                                         .semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE};
    const VkSemaphoreCreateInfo semaphore_info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, .pNext = &type};
    check(vkCreateSemaphore(device, &semaphore_info, nullptr, &timeline_), "vkCreateSemaphore");
}

Frame::~Frame() {
    vkDeviceWaitIdle(gpu.device.handle);
    vkDestroySemaphore(gpu.device.handle, timeline_, nullptr);
    vkDestroyQueryPool(gpu.device.handle, queries_, nullptr);
    vkDestroyCommandPool(gpu.device.handle, pool_, nullptr);
}

void Frame::begin(glm::uvec2 size_in_pixels, float time_in_seconds) {
    if (size != size_in_pixels) {
        size = size_in_pixels;
        images_.clear();
        hdr = Image(gpu.device, {.name = "hdr", .format = VK_FORMAT_R16G16B16A16_SFLOAT, .size = size});
        depth = Image(gpu.device, {.name = "depth", .format = VK_FORMAT_D32_SFLOAT, .size = size});
        mean_ = Image();
        output = Image(gpu.device, {.name = "output", .format = VK_FORMAT_R8G8B8A8_UNORM, .size = size});
    }
    if (samples.count > 1 && !mean_)
        mean_ = Image(gpu.device, {.name = "mean", .format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = size});
    time_s = time_in_seconds;
    for (const Recorded& pass : passes_) free_commands_.push_back(pass.commands);
    passes_.clear();
    outputs.clear();
    arena_ = 0;
    arena_used_ = 0;
    check(vkResetCommandPool(gpu.device.handle, pool_, 0), "vkResetCommandPool");
    vkResetQueryPool(gpu.device.handle, queries_, 0, 2 * max_passes);
}

VkCommandBuffer Frame::begin_pass(const std::string& name, const char* stage) {
    if (passes_.size() >= max_passes) throw Failure("a frame has at most " + std::to_string(max_passes) + " passes");
    VkCommandBuffer commands = VK_NULL_HANDLE;
    if (!free_commands_.empty()) {
        commands = free_commands_.back();
        free_commands_.pop_back();
    } else {
        const VkCommandBufferAllocateInfo allocate{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                   .commandPool = pool_,
                                                   .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                   .commandBufferCount = 1};
        check(vkAllocateCommandBuffers(gpu.device.handle, &allocate, &commands), "vkAllocateCommandBuffers");
    }
    const VkCommandBufferBeginInfo begin_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                              .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    check(vkBeginCommandBuffer(commands, &begin_info), "vkBeginCommandBuffer");
    passes_.push_back({name, stage, commands});
    gpu.device.begin_label(commands, name.c_str());
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_,
                         2 * static_cast<uint32_t>(passes_.size() - 1));
    return commands;
}

void Frame::end_pass() {
    const VkCommandBuffer commands = passes_.back().commands;
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_,
                         2 * static_cast<uint32_t>(passes_.size() - 1) + 1);
    gpu.device.end_label(commands);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
}

void Frame::run_after_pass(size_t outputs_before) {
    if (!after_pass || outputs.size() == outputs_before) return;
    const auto function = std::exchange(after_pass, nullptr);  // its own passes do not call it
    function();
    after_pass = function;
}

void Frame::raster(const std::string& name, const RasterTargets& targets, const std::function<void(Raster&)>& record) {
    const size_t outputs_before = outputs.size();
    const VkCommandBuffer commands = begin_pass(name, "raster");
    const std::vector<const Given*> given = expand(targets.with, root);
    const std::vector<Resource> reads = with_given(targets.reads, given);
    shader_barriers(commands, false, reads, targets.writes);
    Raster pass(*this, name, commands, reads, targets.writes, given);
    std::vector<VkRenderingAttachmentInfo> colors;
    glm::uvec2 extent = size;
    for (const Resource& target : targets.color) {
        barrier(commands, *target.image,
                {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                 VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT,
                 VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true});
        const glm::vec4& c = targets.clear;
        colors.push_back(attachment(*target.image, targets.keep, {.color = {.float32 = {c.r, c.g, c.b, c.a}}}));
        pass.formats.color.push_back(target.image->desc.format);
        extent = target.image->desc.size;
        outputs.emplace_back(name, target.image);
    }
    VkRenderingAttachmentInfo depth_info{};
    if (targets.depth) {
        const Image& image = *targets.depth.image;
        barrier(commands, image,
                {VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
                 VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
                 VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, true});
        depth_info = attachment(image, targets.keep || targets.keep_depth, {.depthStencil = {.depth = 0.0f}});
        pass.formats.depth = image.desc.format;
        extent = image.desc.size;
        outputs.emplace_back(name + " depth", &image);
    }
    const VkRect2D area{.extent = {extent.x, extent.y}};
    const VkRenderingInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                               .renderArea = area,
                               .layerCount = 1,
                               .colorAttachmentCount = static_cast<uint32_t>(colors.size()),
                               .pColorAttachments = colors.data(),
                               .pDepthAttachment = targets.depth ? &depth_info : nullptr};
    vkCmdBeginRendering(commands, &info);
    const VkViewport viewport{.width = float(extent.x), .height = float(extent.y), .maxDepth = 1.0f};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
    // A pass that throws is ended all the same: its barriers are in the images' histories, so it must be submitted.
    const auto end_rendering = [&] {
        vkCmdEndRendering(commands);
        end_pass();
    };
    try {
        record(pass);
    } catch (...) {
        end_rendering();
        throw;
    }
    end_rendering();
    run_after_pass(outputs_before);
}

void Frame::compute(const std::string& name, const ComputeAccess& access, const std::function<void(Compute&)>& record) {
    const size_t outputs_before = outputs.size();
    const VkCommandBuffer commands = begin_pass(name, "compute");
    const std::vector<const Given*> given = expand(access.with, root);
    const std::vector<Resource> reads = with_given(access.reads, given);
    shader_barriers(commands, true, reads, access.writes);
    for (const Resource& written : access.writes)
        if (written.image) outputs.emplace_back(name, written.image);
    Compute pass(*this, name, commands, reads, access.writes, given);
    try {
        record(pass);
    } catch (...) {
        end_pass();
        throw;
    }
    end_pass();
    run_after_pass(outputs_before);
}

void Frame::transfer(const std::string& name, const ComputeAccess& access,
                     const std::function<void(VkCommandBuffer)>& record) {
    const VkCommandBuffer commands = begin_pass(name, "transfer");
    const auto all = [&](const std::vector<Resource>& list, const Access& next) {
        for (const Resource& r : list) r.image ? barrier(commands, *r.image, next) : barrier(commands, *r.buffer, next);
    };
    all(access.reads,
        {VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, false});
    all(access.writes,
        {VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, true});
    record(commands);
    end_pass();
}

Image& Frame::image(const std::string& name, Image::Desc desc) {
    desc.name = name;
    const auto it = images_.find(name);
    if (it != images_.end() && it->second.desc.size == desc.size && it->second.desc.format == desc.format &&
        it->second.desc.mips == desc.mips && it->second.desc.layers == desc.layers)
        return it->second;
    return images_[name] = Image(gpu.device, desc);
}

VkDescriptorBufferInfo Frame::copy_to_arena(std::span<const std::byte> bytes) {
    const VkDeviceSize alignment = gpu.device.properties.limits.minUniformBufferOffsetAlignment;
    arena_used_ = (arena_used_ + alignment - 1) / alignment * alignment;
    if (bytes.size() > arena_bytes) throw Failure("a uniform block is at most 1 MiB");
    if (arena_ < arenas_.size() && arena_used_ + bytes.size() > arena_bytes) ++arena_, arena_used_ = 0;
    if (arena_ >= arenas_.size())
        arenas_.emplace_back(gpu.device, Buffer::Desc{.name = "uniforms", .bytes = arena_bytes, .host_visible = true});
    Buffer& arena = arenas_[arena_];
    std::memcpy(arena.mapped + arena_used_, bytes.data(), bytes.size());
    const VkDescriptorBufferInfo info{.buffer = arena.handle, .offset = arena_used_, .range = bytes.size()};
    arena_used_ += bytes.size();
    return info;
}

}  // namespace lightwalk
