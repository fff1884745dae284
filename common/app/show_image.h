// Shows an image instead of the picture, as a chapter's knob asks: a table, a map, a step of a method.
#pragma once
#include "common/gpu/frame.h"

namespace lightwalk {

struct ShowImage {
    glm::vec3 gain{1.0f};    ///< its light is multiplied by this
    glm::vec4 texels{0.0f};  ///< visible part: origin and size; 0: all of it
    float aspect = 0.0f;     ///< width by height, in the middle of the picture and dark around; 0: stretched over it
    const Buffer* words = nullptr;  ///< with `gate`: the picture is black where that word of 32 bits is 0
    uint32_t gate = 0;
    const char* pass = "look";
};

/// Draws the first level of an image of floats, which shaders may sample, over an RGBA16F image of linear light.
void show_image(Frame& frame, const Image& image, const ImageView& over, const ShowImage& how = {});

/// The same over frame.hdr.
inline void show_image(Frame& frame, const Image& image, const ShowImage& how = {}) {
    show_image(frame, image, frame.hdr, how);
}

}  // namespace lightwalk
