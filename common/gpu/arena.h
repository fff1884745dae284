// Transient memory of one frame: host-visible buffers and descriptor sets, both reset each frame.
#pragma once
#include <span>
#include <vector>

#include "common/gpu/buffer.h"
#include "common/gpu/owned.h"
#include "common/gpu/pipeline.h"

namespace lightwalk {

class Arena {
  public:
    Arena(Device& device, std::string name) : device_(device), name_(std::move(name)) {}

    /// Copies `bytes` into a buffer. The offset is a multiple of `alignment`, in bytes.
    VkDescriptorBufferInfo copy(std::span<const std::byte> bytes, VkDeviceSize alignment);
    void reset() { current_ = 0, used_ = 0; }

  private:
    Device& device_;
    std::string name_;
    std::vector<Buffer> buffers_;
    size_t current_ = 0;
    VkDeviceSize used_ = 0;
};

class DescriptorSets {
  public:
    explicit DescriptorSets(Device& device) : device_(device) {}

    /// Descriptor set holding `writes`, valid until reset().
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
