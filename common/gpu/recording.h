// What one frame in flight needs for itself, from its recording until its passes have ended.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "common/gpu/arena.h"
#include "common/gpu/commands.h"
#include "common/gpu/read_back.h"

namespace lightwalk {

struct PassTime {
    std::string name;
    std::string stage;  ///< raster, compute or transfer: where the time was spent
    double gpu_ms = 0;
};

// [recording]
/// A frame's passes: their commands, their times, and memory that they read. A Frame has as many as it may have in flight,
/// and takes them in turn.
/// Large (14 functions, 14 members): Vulkan's pools.
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

    /// Forgets all that was recorded; nothing of it may be running.
    void restart();

    /// Room for one pass more.
    bool has_room() const;
    Commands& begin_pass(const std::string& name, const char* stage);
    void end_pass();

    /// Within a pass: a command buffer for commands that are not listed, until shut().
    VkCommandBuffer open();
    void shut();

    /// Makes a command buffer from the list, unless one of the same commands was made for an earlier frame.
    void close();
    std::vector<VkCommandBufferSubmitInfo> buffers;  ///< made so far, in order

    /// Of a recording that was submitted: how many passes have ended by now.
    size_t ended_passes() const;

    /// Of one that has ended.
    void read_times();
    void deliver();

  private:
    /// A command buffer and the commands in it.
    struct Kept {
        VkCommandBuffer handle = VK_NULL_HANDLE;
        Commands commands;
        uint64_t changes = 0;  ///< when it was recorded: objects may have gone since
        uint64_t used = 0;     ///< by which frame
    };
    std::array<Kept, 2>& next();
    Kept& begin_next();
    void add(Kept& kept);
    Device& device_;
    Commands commands_;
    std::vector<std::array<Kept, 2>> kept_;  ///< by position: two, since images may take turns from frame to frame
    uint64_t frames_ = 0;
    Owned<VkCommandPool, vkDestroyCommandPool> pool_;
    Owned<VkQueryPool, vkDestroyQueryPool> queries_;
    std::vector<Owned<VkEvent, vkDestroyEvent>> ended_;  ///< a software device's, by pass
};
// [/recording]

}  // namespace lightwalk
