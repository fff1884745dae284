// One frame in flight: its command buffer, its pass times, and the memory that its passes read.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "common/gpu/arena.h"
#include "common/gpu/read_back.h"

namespace lightwalk {

struct PassTime {
    std::string name;
    std::string stage;  ///< raster, compute or transfer: where the time was spent
    double gpu_ms = 0;
};

// [recording]
/// A frame's passes, recorded into one command buffer as they are stated. A Frame has one Recording for each frame it may
/// have in flight, and takes them in turn.
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
    uint64_t use = 0;      ///< Device::begin_use; 0: none
    uint64_t ends_at = 0;  ///< value of the frame's timeline when it has ended; 0: not submitted

    /// A read-back's bytes, on their way.
    struct Arriving {
        std::shared_ptr<ReadBack::State> state;
        Buffer staging;
        size_t bytes;
    };
    std::vector<Arriving> read_backs;

    /// Drops the recorded commands and begins the command buffer again. Nothing recorded before may be running.
    void restart();

    /// False at the most passes that one submission can time.
    bool has_room() const;
    VkCommandBuffer begin_pass(const std::string& name, const char* stage);
    void end_pass();

    /// Ends the command buffer and returns it, ready to submit.
    VkCommandBuffer close();

    /// Number of submitted passes that have ended by now.
    size_t ended_passes() const;

    /// Both need an ended submission.
    void read_times();
    void deliver();

  private:
    void wait_for_all() const;
    Device& device_;
    Owned<VkCommandPool, vkDestroyCommandPool> pool_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    Owned<VkQueryPool, vkDestroyQueryPool> queries_;
    std::vector<Owned<VkEvent, vkDestroyEvent>> ended_;  ///< by pass
};
// [/recording]

}  // namespace lightwalk
