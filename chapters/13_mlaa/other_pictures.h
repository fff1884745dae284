// Pictures of chapters 11 and 12, whose edges no triangle has made, or whose triangles are drawn elsewhere.
#pragma once
#include "05_shadow_maps/shadow.h"
#include "11_fractals/julia.h"
#include "11_fractals/terrain.h"
#include "12_skin/skin.h"

namespace lightwalk {

/// Their modules, in the chapter under the names that their scene files know.
class OtherPictures {
  public:
    explicit OtherPictures(Module& chapter);
    Julia julia;
    Terrain terrain;
    Skin skin;
    Rays rays;
    EnvironmentLight environment;

    /// What shades the head beside these.
    struct Lit {
        const Maps& maps;
        Lights& lights;
        Shadow& shadow;
    };
    void prepare_head(Gpu& gpu, const Scene& scene);

    // Each into frame.hdr; the head in the view that the frame has.
    void draw_julia(Frame& frame, const Scene& scene, const Camera& camera);
    void draw_terrain(Frame& frame, const Scene& scene, const Camera& camera);
    void draw_head(Frame& frame, const Scene& scene, const Camera& camera, const Lit& lit);

  private:
    Pipeline backdrop_ = compute({.shader = "12_skin/backdrop.comp"});
};

}  // namespace lightwalk
