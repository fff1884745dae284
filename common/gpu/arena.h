// Memory of one frame: bytes for the device to read, and descriptor sets. Both restart with every frame.
#pragma once
#include <span>
#include <vector>

#include "common/gpu/buffer.h"
#include "common/gpu/owned.h"
#include "common/gpu/pipeline.h"

namespace lightwalk {

/// Host-visible buffers filled one after the other. Each frame in flight has its own.
class Arena {
  public:
    Arena(Device& device, std::string name) : device_(device), name_(std::move(name)) {}

    /// Copies the bytes to a place at a multiple of `alignment`.
    VkDescriptorBufferInfo copy(std::span<const std::byte> bytes, VkDeviceSize alignment);
    void reset() { current_ = 0, used_ = 0; }

  private:
    Device& device_;
    std::string name_;
    std::vector<Buffer> buffers_;
    size_t current_ = 0;
    VkDeviceSize used_ = 0;
};

/// Descriptor sets, allocated from pools and written once, for one draw or dispatch and those after it that bind the same.
class DescriptorSets {
  public:
    explicit DescriptorSets(Device& device) : device_(device) {}

    /// A set that holds `writes`, until the next reset().
    VkDescriptorSet make(const BuiltPipeline& pipeline, std::span<VkWriteDescriptorSet> writes);
    void reset();

  private:
    using Pool = Owned<VkDescriptorPool, vkDestroyDescriptorPool>;
    Pool make_pool(const BuiltPipeline& pipeline) const;
    VkDescriptorSet allocate(const BuiltPipeline& pipeline);
    Device& device_;
    std::vector<Pool> pools_;
    size_t current_ = 0;
};

}  // namespace lightwalk
