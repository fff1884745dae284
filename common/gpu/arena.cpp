#include "common/gpu/arena.h"

#include <algorithm>
#include <cstring>

namespace lightwalk {
namespace {

constexpr VkDeviceSize least_bytes = 1 << 20;
constexpr uint32_t sets_per_pool = 256;

}  // namespace

VkDescriptorBufferInfo Arena::copy(std::span<const std::byte> bytes, VkDeviceSize alignment) {
    const auto aligned = [&] { return (used_ + alignment - 1) / alignment * alignment; };
    while (current_ < buffers_.size() && aligned() + bytes.size() > buffers_[current_].bytes) {
        ++current_;
        used_ = 0;
    }
    if (current_ == buffers_.size())
        buffers_.emplace_back(
            device_, Buffer::Desc{.name = name_, .bytes = std::max(least_bytes, bytes.size()), .host_visible = true});
    const Buffer& buffer = buffers_[current_];
    used_ = aligned();
    if (!bytes.empty()) std::memcpy(buffer.mapped + used_, bytes.data(), bytes.size());
    const VkDescriptorBufferInfo place{.buffer = buffer.handle, .offset = used_, .range = bytes.size()};
    used_ += bytes.size();
    return place;
}

DescriptorSets::Pool DescriptorSets::make_pool(const BuiltPipeline& pipeline) const {
    std::vector<VkDescriptorPoolSize> sizes;
    for (const VkDescriptorType type : {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                        VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}) {
        uint32_t own = 0;
        for (const Binding& binding : pipeline.bindings)
            if (binding.type == type) own += binding.count;
        sizes.push_back({type, sets_per_pool * std::max(own, 4u)});
    }
    const VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                          .maxSets = sets_per_pool,
                                          .poolSizeCount = static_cast<uint32_t>(sizes.size()),
                                          .pPoolSizes = sizes.data()};
    Pool pool;
    check(vkCreateDescriptorPool(device_.handle, &info, nullptr, pool.put(device_.handle)), "vkCreateDescriptorPool");
    device_.set_name(VK_OBJECT_TYPE_DESCRIPTOR_POOL, reinterpret_cast<uint64_t>(VkDescriptorPool(pool)),
                     "descriptor sets of a frame");
    return pool;
}

VkDescriptorSet DescriptorSets::allocate(const BuiltPipeline& pipeline) {
    for (;; ++current_) {
        const bool fresh = current_ == pools_.size();
        if (fresh) pools_.push_back(make_pool(pipeline));
        const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                               .descriptorPool = pools_[current_],
                                               .descriptorSetCount = 1,
                                               .pSetLayouts = &pipeline.set_layout};
        VkDescriptorSet set = VK_NULL_HANDLE;
        const VkResult result = vkAllocateDescriptorSets(device_.handle, &info, &set);
        if (result == VK_SUCCESS) return set;
        const bool full = result == VK_ERROR_OUT_OF_POOL_MEMORY || result == VK_ERROR_FRAGMENTED_POOL;
        if (fresh || !full) check(result, "vkAllocateDescriptorSets");
    }
}

VkDescriptorSet DescriptorSets::make(const BuiltPipeline& pipeline, std::span<VkWriteDescriptorSet> writes) {
    const VkDescriptorSet set = allocate(pipeline);
    for (VkWriteDescriptorSet& write : writes) write.dstSet = set;
    vkUpdateDescriptorSets(device_.handle, static_cast<uint32_t>(writes.size()), writes.data(), 0, nullptr);
    return set;
}

void DescriptorSets::reset() {
    for (const Pool& pool : pools_) vkResetDescriptorPool(device_.handle, pool, 0);
    current_ = 0;
}

}  // namespace lightwalk
