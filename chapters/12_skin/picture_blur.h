// The blur over the picture in place of one over the texture.
#pragma once
#include "12_skin/screen_kernel.h"
#include "common/app/target.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// J. Jimenez et al., "Separable Subsurface Scattering", Computer Graphics Forum 34(6), 2015, with the profile's own
/// weights along a line: an edge that runs along the picture's rows or columns on a surface that faces the eye comes
/// out exactly.
class PictureBlur {
  public:
    explicit PictureBlur(Module& owner)
        : light(owner, {.name = "light"}), after(owner, {.name = "after"}), half_(owner, {.name = "half"}) {}

    Target light;  ///< what is blurred; a: how far away, in metres, 0 where there is nothing
    Target after;  ///< by what it is then multiplied

    /// Blurs `light` along both directions, and adds it to the picture. `fov_y_rad` and the picture's height say how
    /// wide a pixel is.
    void record(Frame& frame, float fov_y_rad);

  private:
    Target half_;
    Buffer kernel_;
    Pipeline line_ = compute({.shader = "12_skin/separable.comp"});
    Pipeline add_ = compute({.shader = "12_skin/add_screen.comp"});
};

}  // namespace lightwalk
