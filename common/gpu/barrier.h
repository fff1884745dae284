// Barriers derived from the resource accesses that passes declare.
#pragma once
#include <vector>

#include "common/gpu/buffer.h"
#include "common/gpu/image.h"

namespace lightwalk {

class Barriers {
  public:
    /// Adds the barriers that `next` requires after earlier accesses, and updates the history. Neighbours share one.
    void add(const ImageView& view, const Access& next);
    void add(const Buffer& buffer, const Access& next);

    void record(VkCommandBuffer commands);

    std::vector<VkImageMemoryBarrier2> images;
    std::vector<VkBufferMemoryBarrier2> buffers;
};

template <class T>
void barrier(VkCommandBuffer commands, const T& resource, const Access& next) {
    Barriers one;
    one.add(resource, next);
    one.record(commands);
}

void barrier(VkCommandBuffer commands, const VkMemoryBarrier2& memory);

}  // namespace lightwalk
