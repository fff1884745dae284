// Display of an image instead of the picture: a table, a map, an intermediate result.
#pragma once
#include "common/gpu/frame.h"

namespace lightwalk {

struct ShowImage {
    glm::vec3 gain{1.0f};
    glm::vec4 texels{0.0f};         ///< visible part: origin and size; size 0: all
    float aspect = 0.0f;            ///< width / height of the letterboxed image; 0: stretched
    const Buffer* words = nullptr;  ///< black where the 32-bit word `gate` is 0
    uint32_t gate = 0;
    const char* pass = "look";
};

/// Draws the first mip of a sampled float image over a linear RGBA16F image.
void show_image(Frame& frame, const Image& image, const ImageView& over, const ShowImage& how = {});

inline void show_image(Frame& frame, const Image& image, const ShowImage& how = {}) {
    show_image(frame, image, frame.hdr, how);
}

}  // namespace lightwalk
