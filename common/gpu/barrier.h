// Barriers derived from the statements of a pass, recorded at once.
#pragma once
#include <vector>

#include "common/gpu/buffer.h"
#include "common/gpu/image.h"

namespace lightwalk {

class Barriers {
  public:
    /// Adds the barriers that `next` requires after all earlier accesses to those mips and layers. Parts of a view
    /// with equal histories share a barrier.
    void add(const ImageView& view, const Access& next);
    void add(const Buffer& buffer, const Access& next);

    /// One command for all that was added, or none; forgets them.
    void record(VkCommandBuffer commands);

    std::vector<VkImageMemoryBarrier2> images;
    std::vector<VkBufferMemoryBarrier2> buffers;
};

/// One alone.
template <class T>
void barrier(VkCommandBuffer commands, const T& resource, const Access& next) {
    Barriers one;
    one.add(resource, next);
    one.record(commands);
}

/// A barrier between stages alone, for all memory.
void barrier(VkCommandBuffer commands, const VkMemoryBarrier2& memory);

}  // namespace lightwalk
