// One frame in flight: command buffer, timestamps, transient memory.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "common/gpu/arena.h"
#include "common/gpu/read_back.h"

namespace lightwalk {

struct PassTime {
    std::string name;
    std::string stage;
    double gpu_ms = 0;
};

/// Command buffer of one frame. A Frame cycles through one Recording per frame in flight.
class Recording {
  public:
    explicit Recording(Device& device);
    Recording(const Recording&) = delete;

    Arena uniforms, uploads;
    DescriptorSets sets;
    struct Pass {
        std::string name;
        const char* stage;
    };
    std::vector<Pass> passes;
    std::vector<PassTime> times;
    uint64_t use = 0;      ///< Device::begin_use(); 0: none
    uint64_t ends_at = 0;  ///< timeline value at the end of the frame; 0: not submitted

    struct Arriving {
        std::shared_ptr<ReadBack::State> state;
        Buffer staging;
        size_t bytes;
    };
    std::vector<Arriving> read_backs;

    /// Resets the command buffer, which must not be in use.
    void restart();

    /// False at the maximum number of passes that one submission can time.
    bool has_room() const;
    VkCommandBuffer begin_pass(const std::string& name, const char* stage);
    void end_pass();

    VkCommandBuffer close();

    size_t ended_passes() const;

    /// Requires an ended submission, as does deliver().
    void read_times();
    void deliver();

  private:
    void wait_for_all() const;
    Device& device_;
    Owned<VkCommandPool, vkDestroyCommandPool> pool_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    Owned<VkQueryPool, vkDestroyQueryPool> queries_;
    std::vector<Owned<VkEvent, vkDestroyEvent>> ended_;
};

}  // namespace lightwalk
