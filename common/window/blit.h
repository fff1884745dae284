// Copies a rectangle of one image to another, scaled and with the formats converted.
#pragma once
#include "common/gpu/image.h"

namespace lightwalk {

/// Pixels.
struct Area {
    glm::uvec2 corner{0}, size{0};
};

/// For a transfer pass that states both images. Sizes that differ are filtered linearly; an empty area copies nothing.
void blit(VkCommandBuffer commands, const Image& from, const Area& source, const Image& to, const Area& target);

}  // namespace lightwalk
