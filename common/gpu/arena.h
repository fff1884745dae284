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

/// Sets for pipelines that have more bindings than can be pushed. Frames mostly ask for the same ones in the same order:
/// those are written once.
class DescriptorSets {
  public:
    explicit DescriptorSets(Device& device) : device_(device) {}

    /// A set that holds `writes`, until the next reset().
    VkDescriptorSet make(const BuiltPipeline& pipeline, std::span<VkWriteDescriptorSet> writes);
    void reset();
    size_t count = 0;      ///< made since then
    uint64_t written = 0;  ///< in all

  private:
    using Pool = Owned<VkDescriptorPool, vkDestroyDescriptorPool>;
    struct Made {
        VkDescriptorSetLayout layout = VK_NULL_HANDLE;
        VkDescriptorSet set = VK_NULL_HANDLE;
        std::vector<uint64_t> contents;
        uint64_t destroyed = 0;  ///< Device::destroyed(), when it was written
    };
    Pool make_pool(const BuiltPipeline& pipeline) const;
    VkDescriptorSet allocate(const BuiltPipeline& pipeline);
    Device& device_;
    std::vector<Pool> pools_;
    std::vector<Made> made_;  ///< in the order in which frames ask for them
    size_t current_ = 0;
    bool reordered_ = false;
};

}  // namespace lightwalk
