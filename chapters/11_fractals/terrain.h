// Terrain drawing: a flat grid displaced by the vertex shader, over noise that moves beneath it without end.
#pragma once
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/preetham.h"
#include "11_fractals/noise.h"
#include "11_fractals/ring_grid.h"
#include "11_fractals/terrain_data.h"
#include "common/app/world.h"
#include "common/scene/image_pool.h"

namespace lightwalk {

struct TerrainLook : Module {
    using Module::Module;
    Knob<glm::vec3> land{*this, "land", {0.26f, 0.3f, 0.12f}, {glm::vec3(0), glm::vec3(1)}, "Albedo of level land"};
    Knob<glm::vec3> rock{*this, "rock", {0.36f, 0.31f, 0.28f}, {glm::vec3(0), glm::vec3(1)}, "Albedo of steep land"};
    Knob<glm::vec3> snow{*this, "snow", {0.9f, 0.92f, 0.95f}, {glm::vec3(0), glm::vec3(1)}, "Albedo of snow"};
    Knob<float> begins{*this,
                       "begins",
                       1.3f,
                       {-4.0f, 4.0f},
                       "Beginning of snow: this value minus begins_slope times the y of the normal"};
    Knob<float> begins_slope{
        *this, "begins_slope", 1.5f, {0.0f, 8.0f}, "Dependence of the beginning of snow on the y of the normal"};
    Knob<float> ends{*this,
                     "ends",
                     1.6f,
                     {-4.0f, 4.0f},
                     "Full cover of snow: this value minus ends_slope times the y of the normal"};
    Knob<float> ends_slope{
        *this, "ends_slope", 1.6f, {0.0f, 8.0f}, "Dependence of the full cover of snow on the y of the normal"};
};

/// A drawing under the scene's sun: the ground, a sky of its own where nothing else is drawn, and fog over both. The
/// view's x and z count from where the flight has come to, and its y from the ground there, as four octaves have it.
struct Terrain : Drawing {
    Terrain(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"central", "analytic"},
                  "analytic",
                  "Normal of the ground: central differences of four heights, or the derivative of the sum of octaves"};
    Choice octaves{*this,
                   "octaves",
                   {"fixed", "footprint"},
                   "footprint",
                   "Number of octaves: most_octaves everywhere, or as many as a pixel or a cell of the grid can show"};
    Choice shadow{*this,
                  "shadow",
                  {"none", "smooth", "marched"},
                  "smooth",
                  "Shadow of mountains: none, the light of a smoother ground, or a ray to the sun for every pixel"};
    Choice shaded{
        *this,
        "shaded",
        {"raster", "visibility"},
        "raster",
        "Shading of the ground: as it is drawn, by the fragment shader (raster), or in compute, once for each "
        "pixel of a visibility buffer"};
    Choice show{*this,
                "show",
                {"picture", "normals", "octaves"},
                "picture",
                "Picture shown: the landscape, its normals, or the number of octaves"};
    Knob<bool> stitch{*this, "stitch", true, "Stitching of the rings of the grid, so that they meet without cracks"};
    Knob<float> wave_m{*this, "wave_m", 5000.0f, {10.0f, 1e5f}, "Cell size of the first octave", "m"};
    Knob<float> height_m{*this, "height_m", 1000.0f, {0.0f, 1e4f}, "Height of the first octave", "m"};
    Knob<float> erosion{*this, "erosion", 0.15f, {0.0f, 16.0f}, "Erosion: smoothing of steep ground; 0 is plain fBm"};
    Knob<float> gain{*this, "gain", 0.46f, {0.05f, 0.9f}, "Gain: height of an octave relative to the one before"};
    Knob<float> most_octaves{*this, "most_octaves", 11.0f, {1.0f, 16.0f}, "Maximum number of octaves"};
    Knob<float> difference_m{*this, "difference_m", 1.0f, {1e-4f, 1e3f}, "Spacing of the differences (method central)",
                             "m"};
    Knob<float> shortest_px{
        *this, "shortest_px", 1.0f, {0.1f, 16.0f}, "Length of the shortest wave (octaves footprint)", "px"};
    Knob<float> ambient{*this, "ambient", 0.35f, {0.0f, 1.0f}, "Fraction of the sky seen from a vertical wall"};
    Knob<float> ambient_power{*this, "ambient_power", 2.0f, {0.0f, 16.0f}, "Exponent k of the light of the sky, ny^k"};
    Knob<float> ambient_noise{
        *this, "ambient_noise", 0.0f, {0.0f, 1.0f}, "Noise in the light of the sky, relative to that light"};
    Knob<float> back_light{
        *this,
        "back_light",
        0.0f,
        {0.0f, 4.0f},
        "Second light from the sky 30 degrees high opposite the sun, relative to a whole sky as bright as there"};
    Knob<float> snow_line_m{
        *this, "snow_line_m", 250.0f, {-1e4f, 1e4f}, "Snow line: height where snow begins on level ground", "m"};
    Knob<int> shadow_steps{*this, "shadow_steps", 64, {1, 1024}, "Number of steps of the marched shadow"};
    Knob<int> cells{
        *this, "cells", 128, {8, 1024}, "Number of cells along a side of a ring; rounded to a multiple of 4"};
    Knob<float> spacing_m{*this, "spacing_m", 2.0f, {0.05f, 100.0f}, "Side of a cell in the innermost ring", "m"};
    Knob<int> rings{*this, "rings", 8, {1, 12}, "Number of rings of the grid, each twice as wide as the one within"};
    Knob<float> start_x_km{*this, "start_x_km", 0.0f, {-1e6f, 1e6f}, "Start of the flight, eastwards", "km"};
    Knob<float> start_z_km{*this, "start_z_km", 0.0f, {-1e6f, 1e6f}, "Start of the flight, southwards", "km"};
    Knob<float> speed_m_s{*this, "speed_m_s", 60.0f, {0.0f, 1e4f}, "Speed of the flight in the direction of view",
                          "m/s"};
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
    /// The camera's place in the flight's world at a time, for World::eye(): the view that all drawings have.
    World::Eye eye(const Camera& camera, float time_s) const;
    bool animated() const override { return speed_m_s > 0; }

    void bind(Pass& pass) const override;
    const TerrainNow& now() const { return now_; }
    const View& from() const { return from_; }  ///< the view drawn last, from the grid's middle

  private:
    void place(const Frame& frame, const View& view);
    void draw_ground(Frame& frame, Canvas& canvas);
    void draw_visible(Frame& frame, const View& view, Canvas& canvas);
    void bind_maps(Pass& pass) const;
    const Scene* scene_ = nullptr;
    Pipeline ground_ = graphics({.vertex = "11_fractals/terrain.vert", .fragment = "11_fractals/terrain.frag"});
    Pipeline lift_ = compute({.shader = "11_fractals/terrain_lift.comp"});
    Pipeline visible_ =
        graphics({.vertex = "11_fractals/terrain_visible.vert", .fragment = "05_shadow_maps/visible.frag"});
    Pipeline shade_ = compute({.shader = "11_fractals/terrain_shade.comp"});
    Pipeline sky_ = compute({.shader = "11_fractals/terrain_sky.comp"});
    std::unique_ptr<ImagePool> images_;
    std::shared_ptr<Image> land_, rock_;
    RingGrid grid_;
    Buffer lifted_;  ///< vertices of the grid
    Image seen_;     ///< the visibility buffer
    TerrainNow now_{};
    View from_;
};

}  // namespace lightwalk
