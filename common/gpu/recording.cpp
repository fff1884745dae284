#include "common/gpu/recording.h"

#include <algorithm>
#include <utility>

#include "common/gpu/gpu_work.h"

namespace lightwalk {
namespace {

constexpr uint32_t max_passes = 2048;  // of one submission: forty lights with blurred moments take a thousand

}  // namespace

Recording::Recording(Device& device)
    : uniforms(device, "uniforms"), uploads(device, "uploads"), sets(device), device_(device) {
    const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                            .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                            .queueFamilyIndex = device.queue_family};
    check(vkCreateCommandPool(device.handle, &pool_info, nullptr, pool_.put(device.handle)), "vkCreateCommandPool");
    const VkQueryPoolCreateInfo query_info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                           .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                           .queryCount = 2 * max_passes};
    check(vkCreateQueryPool(device.handle, &query_info, nullptr, queries_.put(device.handle)), "vkCreateQueryPool");
    device.set_name(VK_OBJECT_TYPE_COMMAND_POOL, reinterpret_cast<uint64_t>(VkCommandPool(pool_)), "passes");
    device.set_name(VK_OBJECT_TYPE_QUERY_POOL, reinterpret_cast<uint64_t>(VkQueryPool(queries_)), "pass times");
    vkResetQueryPool(device.handle, queries_, 0, 2 * max_passes);
}

void Recording::restart() {
    uniforms.reset();
    uploads.reset();
    sets.reset();
    commands_.clear();
    buffers.clear();
    ++frames_;
    if (passes.empty()) return;
    vkResetQueryPool(device_.handle, queries_, 0, 2 * static_cast<uint32_t>(passes.size()));
    for (size_t i = 0; i < passes.size() && i < ended_.size(); ++i) vkResetEvent(device_.handle, ended_[i]);
    passes.clear();
}

bool Recording::has_room() const { return passes.size() < max_passes; }

Commands& Recording::begin_pass(const std::string& name, const char* stage) {
    passes.push_back({name, stage});
    commands_.begin_label(device_, name);
    commands_.write_timestamp(queries_, 2 * static_cast<uint32_t>(passes.size() - 1));
    // Once it has drawn, that one writes a time when it draws next, but computes at once. At a barrier without resources it
    // waits for all it was given.
    if (device_.software()) commands_.wait_for_all();
    return commands_;
}

void Recording::end_pass() {
    commands_.write_timestamp(queries_, 2 * static_cast<uint32_t>(passes.size() - 1) + 1);
    commands_.end_label(device_);
    if (!device_.software()) return;
    // Asked for its times, Mesa's rasteriser waits for all commands.
    if (ended_.size() < passes.size()) {
        const VkEventCreateInfo info{.sType = VK_STRUCTURE_TYPE_EVENT_CREATE_INFO};
        check(vkCreateEvent(device_.handle, &info, nullptr, ended_.emplace_back().put(device_.handle)),
              "vkCreateEvent");
    }
    // Mesa 25 sets an event once the commands before it are prepared, though not drawn.
    commands_.wait_for_all();
    commands_.set_event(ended_[passes.size() - 1]);
}

std::array<Recording::Kept, 2>& Recording::next() {
    if (kept_.size() == buffers.size()) kept_.emplace_back();
    return kept_[buffers.size()];
}

// In place of the one that was not used for longer.
Recording::Kept& Recording::begin_next() {
    std::array<Kept, 2>& two = next();
    Kept& kept = two[0].used <= two[1].used ? two[0] : two[1];
    kept.commands.clear();
    if (!kept.handle) {
        const VkCommandBufferAllocateInfo allocate{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                   .commandPool = pool_,
                                                   .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                   .commandBufferCount = 1};
        check(vkAllocateCommandBuffers(device_.handle, &allocate, &kept.handle), "vkAllocateCommandBuffers");
        device_.set_name(VK_OBJECT_TYPE_COMMAND_BUFFER, reinterpret_cast<uint64_t>(kept.handle), "frame");
    }
    const VkCommandBufferBeginInfo begin_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    check(vkBeginCommandBuffer(kept.handle, &begin_info), "vkBeginCommandBuffer");
    ++gpu_work.command_buffers;
    return kept;
}

void Recording::add(Kept& kept) {
    kept.used = frames_;
    buffers.push_back({.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO, .commandBuffer = kept.handle});
}

void Recording::close() {
    if (commands_.empty()) return;
    // A handle may have become another object's, and no buffer outlives what it uses, or a later write to its sets.
    const uint64_t changes = device_.destroyed() + sets.written;
    std::array<Kept, 2>& two = next();
    const auto same = std::ranges::find_if(
        two, [&](const Kept& kept) { return kept.changes == changes && kept.commands == commands_; });
    if (same != two.end()) {
        add(*same);
    } else {
        Kept& kept = begin_next();
        commands_.record(device_, kept.handle);
        check(vkEndCommandBuffer(kept.handle), "vkEndCommandBuffer");
        kept.changes = changes;
        std::swap(kept.commands, commands_);
        add(kept);
    }
    commands_.clear();
}

// A label ends in the buffer in which it began: validation layers keep them by buffer.
VkCommandBuffer Recording::open() {
    commands_.end_label(device_);
    close();
    Kept& kept = begin_next();
    add(kept);
    device_.begin_label(kept.handle, passes.back().name.c_str());
    return kept.handle;
}

void Recording::shut() {
    const VkCommandBuffer commands = buffers.back().commandBuffer;
    device_.end_label(commands);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    commands_.begin_label(device_, passes.back().name);
}

size_t Recording::ended_passes() const {
    size_t count = 0;
    const auto has_ended = [&](size_t pass) {
        if (device_.software()) return vkGetEventStatus(device_.handle, ended_[pass]) == VK_EVENT_SET;
        uint64_t stamp = 0;
        return vkGetQueryPoolResults(device_.handle, queries_, 2 * static_cast<uint32_t>(pass) + 1, 1, sizeof stamp,
                                     &stamp, sizeof stamp, VK_QUERY_RESULT_64_BIT) == VK_SUCCESS;
    };
    while (count < passes.size() && has_ended(count)) ++count;
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
