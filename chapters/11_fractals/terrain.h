// A landscape without an end: a flat grid that the vertex shader lifts, over noise that moves beneath it.
#pragma once
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/preetham.h"
#include "11_fractals/noise.h"
#include "11_fractals/terrain_data.h"
#include "common/scene/image_pool.h"

namespace lightwalk {

struct TerrainLook : Module {
    using Module::Module;
    Knob<glm::vec3> land{*this, "land", {0.26f, 0.3f, 0.12f}, {glm::vec3(0), glm::vec3(1)}, "albedo of level land"};
    Knob<glm::vec3> rock{*this, "rock", {0.36f, 0.31f, 0.28f}, {glm::vec3(0), glm::vec3(1)}, "albedo of steep land"};
    Knob<glm::vec3> snow{*this, "snow", {0.9f, 0.92f, 0.95f}, {glm::vec3(0), glm::vec3(1)}, "albedo of snow"};
    Knob<float> begins{*this, "begins", 1.3f, {-4.0f, 4.0f}, "snow begins at this minus begins_slope times normal y"};
    Knob<float> begins_slope{
        *this, "begins_slope", 1.5f, {0.0f, 8.0f}, "how much less snow there is where it is steep"};
    Knob<float> ends{*this, "ends", 1.6f, {-4.0f, 4.0f}, "snow is whole at this minus ends_slope times normal y"};
    Knob<float> ends_slope{*this, "ends_slope", 1.6f, {0.0f, 8.0f}, "the same for whole snow"};
};

// [terrain]
/// A drawing under the scene's sun: the ground, a sky of its own where nothing else is drawn, and fog over both. The
/// view's x and z count from where the flight has come to, and its y from the ground there, as four octaves have it.
struct Terrain : Drawing {
    Terrain(Module& owner, std::string name) : Drawing(owner, std::move(name), "terrain") {}

    Choice method{*this,
                  "method",
                  {"central", "analytic"},
                  "analytic",
                  "the ground's normal: by four more heights, or from the derivative of the sum of octaves"};
    Choice octaves{*this,
                   "octaves",
                   {"fixed", "footprint"},
                   "footprint",
                   "how many: most_octaves everywhere, or no more than a pixel or a cell of the grid can show"};
    Choice shadow{*this,
                  "shadow",
                  {"none", "smooth", "marched"},
                  "smooth",
                  "of mountains: the light of a smoother ground, or a ray to the sun for every pixel"};
    // [/terrain]
    Choice show{*this, "show", {"picture", "normals", "octaves"}, "picture", "the picture, or what it is made from"};
    Knob<bool> stitch{*this, "stitch", true, "rings of the grid meet without cracks"};
    Knob<float> wave_m{*this, "wave_m", 5000.0f, {10.0f, 1e5f}, "cells of the first octave", "m"};
    Knob<float> height_m{*this, "height_m", 1000.0f, {0.0f, 1e4f}, "height of the first octave", "m"};
    Knob<float> erosion{*this, "erosion", 0.15f, {0.0f, 16.0f}, "by how much steep ground is worn smooth; 0: fBm"};
    Knob<float> gain{*this, "gain", 0.46f, {0.05f, 0.9f}, "height of an octave over that of the one before"};
    Knob<float> most_octaves{*this, "most_octaves", 11.0f, {1.0f, 16.0f}, "octaves at most"};
    Knob<float> difference_m{*this, "difference_m", 1.0f, {1e-4f, 1e3f}, "central: how far the heights lie apart", "m"};
    Knob<float> shortest_px{*this, "shortest_px", 1.0f, {0.1f, 16.0f}, "footprint: length of the shortest wave", "px"};
    Knob<float> ambient{*this, "ambient", 0.35f, {0.0f, 1.0f}, "share of the sky that a wall sees"};
    Knob<float> ambient_power{*this, "ambient_power", 2.0f, {0.0f, 16.0f}, "k of the sky's light ny^k"};
    Knob<float> snow_line_m{*this, "snow_line_m", 250.0f, {-1e4f, 1e4f}, "height where snow begins on level ground",
                            "m"};
    Knob<int> shadow_steps{*this, "shadow_steps", 64, {1, 1024}, "of the marched shadow"};
    Knob<int> cells{*this, "cells", 128, {8, 1024}, "of a ring of the grid, along a side; rounded to a multiple of 4"};
    Knob<float> spacing_m{*this, "spacing_m", 2.0f, {0.05f, 100.0f}, "a cell's side in the innermost ring", "m"};
    Knob<int> rings{*this, "rings", 8, {1, 12}, "of the grid, each twice as wide as the one within"};
    Knob<float> start_x_km{*this, "start_x_km", 0.0f, {-1e6f, 1e6f}, "where the flight begins, eastwards", "km"};
    Knob<float> start_z_km{*this, "start_z_km", 0.0f, {-1e6f, 1e6f}, "and southwards", "km"};
    Knob<float> speed_m_s{*this, "speed_m_s", 60.0f, {0.0f, 1e4f}, "of the flight, the way the camera looks", "m/s"};
    TerrainLook look{*this, "look", "terrain_look"};
    Preetham sky{*this, "sky"};
    HeightFog fog{*this, "fog"};

    bool own_sky = true;  ///< false: the caller draws the sky and the fog

    void prepare(Gpu& gpu, Scene& loaded) override;
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

    /// The ground's height in metres at a place of the flight's world, in double precision.
    double ground_m(glm::dvec2 world_m, double octaves) const;
    /// Where the flight is at a time, x and z in metres.
    glm::dvec2 flight_m(const Camera& camera, double time_s) const;
    bool animated() const override { return speed_m_s > 0; }

    void bind(Pass& pass) const override;
    const TerrainNow& now() const { return now_; }
    const View& from() const { return from_; }  ///< the view drawn last, from the grid's middle

  private:
    void place(const Frame& frame, const View& view);
    void make_grid(Frame& frame);
    const Scene* scene_ = nullptr;
    Pipeline ground_ = graphics({.vertex = "11_fractals/terrain.vert", .fragment = "11_fractals/terrain.frag"});
    Pipeline sky_ = compute({.shader = "11_fractals/terrain_sky.comp"});
    std::unique_ptr<ImagePool> images_;
    std::shared_ptr<Image> land_, rock_;
    Buffer indices_;
    uint32_t made_cells_ = 0, whole_ = 0, hollow_ = 0;
    TerrainNow now_{};
    View from_;
};

}  // namespace lightwalk
