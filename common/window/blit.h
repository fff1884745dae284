// Copies a rectangle of one image to another, scaled and with the formats converted.
#pragma once
#include "common/gpu/image.h"

namespace lightwalk {

/// Pixels.
struct Area {
    glm::uvec2 corner{0}, size{0};
};

/// For a transfer pass that states both images. Sizes that differ are filtered linearly; an empty area copies nothing.
inline void blit(VkCommandBuffer commands, const Image& from, const Area& source, const Image& to, const Area& target) {
    if (source.size.x == 0 || source.size.y == 0 || target.size.x == 0 || target.size.y == 0) return;
    const auto offset = [](glm::uvec2 p, int z) { return VkOffset3D{int32_t(p.x), int32_t(p.y), z}; };
    const VkImageSubresourceLayers color{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    const VkImageBlit region{.srcSubresource = color,
                             .srcOffsets = {offset(source.corner, 0), offset(source.corner + source.size, 1)},
                             .dstSubresource = color,
                             .dstOffsets = {offset(target.corner, 0), offset(target.corner + target.size, 1)}};
    vkCmdBlitImage(commands, from.handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.handle,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region,
                   source.size == target.size ? VK_FILTER_NEAREST : VK_FILTER_LINEAR);
}

}  // namespace lightwalk
