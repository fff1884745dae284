#include "common/gpu/recording.h"

#include <utility>

#include "common/gpu/gpu_work.h"

namespace lightwalk {
namespace {

constexpr uint32_t max_passes = 2048;  // per submission; forty lights with blurred moment maps need a thousand

}  // namespace

Recording::Recording(Device& device)
    : uniforms(device, "uniforms"), uploads(device, "uploads"), sets(device), device_(device) {
    const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                            .queueFamilyIndex = device.queue_family};
    check(vkCreateCommandPool(device.handle, &pool_info, nullptr, pool_.put(device.handle)), "vkCreateCommandPool");
    const VkCommandBufferAllocateInfo allocate{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                               .commandPool = pool_,
                                               .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                               .commandBufferCount = 1};
    check(vkAllocateCommandBuffers(device.handle, &allocate, &commands_), "vkAllocateCommandBuffers");
    const VkQueryPoolCreateInfo query_info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                           .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                           .queryCount = 2 * max_passes};
    check(vkCreateQueryPool(device.handle, &query_info, nullptr, queries_.put(device.handle)), "vkCreateQueryPool");
    device.set_name(VK_OBJECT_TYPE_COMMAND_POOL, reinterpret_cast<uint64_t>(VkCommandPool(pool_)), "passes");
    device.set_name(VK_OBJECT_TYPE_COMMAND_BUFFER, reinterpret_cast<uint64_t>(commands_), "frame");
    device.set_name(VK_OBJECT_TYPE_QUERY_POOL, reinterpret_cast<uint64_t>(VkQueryPool(queries_)), "pass times");
    vkResetQueryPool(device.handle, queries_, 0, 2 * max_passes);
}

void Recording::restart() {
    uniforms.reset();
    uploads.reset();
    sets.reset();
    if (!passes.empty()) {
        vkResetQueryPool(device_.handle, queries_, 0, 2 * static_cast<uint32_t>(passes.size()));
        for (size_t i = 0; i < passes.size(); ++i) vkResetEvent(device_.handle, ended_[i]);
        passes.clear();
    }
    check(vkResetCommandPool(device_.handle, pool_, 0), "vkResetCommandPool");
    const VkCommandBufferBeginInfo begin_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                              .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    check(vkBeginCommandBuffer(commands_, &begin_info), "vkBeginCommandBuffer");
}

bool Recording::has_room() const { return passes.size() < max_passes; }

VkCommandBuffer Recording::begin_pass(const std::string& name, const char* stage) {
    passes.push_back({name, stage});
    device_.begin_label(commands_, name.c_str());
    vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_,
                         2 * static_cast<uint32_t>(passes.size() - 1));
    // Lavapipe executes pending commands at barriers; without one, this timestamp would follow the pass's draws.
    wait_for_all();
    return commands_;
}

void Recording::end_pass() {
    vkCmdWriteTimestamp2(commands_, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_,
                         2 * static_cast<uint32_t>(passes.size() - 1) + 1);
    device_.end_label(commands_);
    // Events reveal the running pass: lavapipe answers timestamp queries only after all commands.
    if (ended_.size() < passes.size()) {
        const VkEventCreateInfo info{.sType = VK_STRUCTURE_TYPE_EVENT_CREATE_INFO};
        check(vkCreateEvent(device_.handle, &info, nullptr, ended_.emplace_back().put(device_.handle)),
              "vkCreateEvent");
    }
    wait_for_all();  // Mesa 25 signals events before earlier commands have executed
    const VkMemoryBarrier2 memory{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                                  .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                  .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
    const VkDependencyInfo info{
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &memory};
    vkCmdSetEvent2(commands_, ended_[passes.size() - 1], &info);
}

// Empty barrier: makes lavapipe execute pending commands; no effect on hardware.
void Recording::wait_for_all() const {
    const VkDependencyInfo none{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    vkCmdPipelineBarrier2(commands_, &none);
}

VkCommandBuffer Recording::close() {
    check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
    return commands_;
}

size_t Recording::ended_passes() const {
    size_t count = 0;
    while (count < passes.size() && vkGetEventStatus(device_.handle, ended_[count]) == VK_EVENT_SET) ++count;
    return count;
}

void Recording::read_times() {
    if (passes.empty()) return;
    std::vector<uint64_t> stamps(2 * passes.size());
    check(vkGetQueryPoolResults(device_.handle, queries_, 0, static_cast<uint32_t>(stamps.size()),
                                stamps.size() * sizeof(uint64_t), stamps.data(), sizeof(uint64_t),
                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "vkGetQueryPoolResults");
    const double tick_ms = static_cast<double>(device_.properties.limits.timestampPeriod) * 1e-6;
    for (size_t i = 0; i < passes.size(); ++i)
        times.push_back(
            {passes[i].name, passes[i].stage, static_cast<double>(stamps[2 * i + 1] - stamps[2 * i]) * tick_ms});
    gpu_work.ended_ms = static_cast<double>(stamps.back()) * tick_ms;
}

void Recording::deliver() {
    for (Arriving& one : read_backs) {
        std::swap(one.state->staging, one.staging);
        one.state->bytes = one.bytes;
        ++one.state->number;
        one.state->spare = std::move(one.staging);
    }
    read_backs.clear();
}

}  // namespace lightwalk
