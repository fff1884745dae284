// Barriers from what passes state: those one pass needs, recorded at once.
#pragma once
#include <vector>

#include "common/gpu/buffer.h"
#include "common/gpu/image.h"

namespace lightwalk {

class Barriers {
  public:
    /// What lets `next` follow whatever was done to those mips and layers; nothing where none is needed. Parts of a
    /// view that were used alike share a barrier.
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

}  // namespace lightwalk
