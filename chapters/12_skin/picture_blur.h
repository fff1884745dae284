// Separable blur over the picture, instead of one over the texture.
#pragma once
#include "12_skin/screen_kernel.h"
#include "common/app/drawing.h"

namespace lightwalk {

/// J. Jimenez et al., "Separable Subsurface Scattering", Computer Graphics Forum 34(6), 2015, with the profile's own
/// weights along a line: an edge that runs along the picture's rows or columns on a surface that faces the eye comes
/// out exactly.
class PictureBlur {
  public:
    Image light;  ///< image to blur; a: distance in metres, 0 for none
    Image after;  ///< factor applied afterwards

    /// Before something is drawn into the two.
    void ensure(Device& device, glm::uvec2 size);

    /// Blurs `light` along both directions, and adds it to the picture.
    void record(Frame& frame, const View& view, Canvas& canvas);

  private:
    Image half_;
    Buffer kernel_;
    Pipeline line_ = compute({.shader = "12_skin/separable.comp"});
    Pipeline add_ = compute({.shader = "12_skin/add_screen.comp"});
};

}  // namespace lightwalk
