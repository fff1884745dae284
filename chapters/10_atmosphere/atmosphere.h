// Atmosphere module: in-scattering and transmittance of a planet's air.
#pragma once
#include <vector>

#include "10_atmosphere/air_tables.h"
#include "10_atmosphere/path_part.h"
#include "10_atmosphere/skylight.h"
#include "common/app/drawing.h"
#include "common/base/epoch.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// The work on each path.
struct PathWork {
    int places = 1;        ///< for light scattered once, 1 or more
    int light_places = 1;  ///< from each of them towards the sun
    int walks = 0;         ///< random ones, for light scattered more often
};

/// In order, one part if possible. llvmpipe ends all loops of an invocation after 65,535 iterations together, and
/// returns their intermediate results. Throws InputError if a single random walk may take longer.
std::vector<PathPart> path_parts(const PathWork& work, const Air& air);

/// A drawing that comes after all solid objects, in linear light without air:
///
///     draw(frame, view, canvas, {mountains, planet, atmosphere});
///
/// The planet's middle lies `radius_m` below the world's origin. Where depth is 0 the image holds the planet's ground,
/// if the pixel's ray meets it, else the background beyond the air. Lights and colours are the module's own: to_sun(), and
/// in a pass that states it in `.with` and includes 10_atmosphere/ground_light.glsl, sunlight_on() and skylight_on().
struct Atmosphere : Drawing {
    Atmosphere(Module& owner, std::string name);

    Choice method{*this,
                  "method",
                  {"none", "preetham", "polynomial", "chapman", "march", "tables", "truth"},
                  "tables",
                  "Light of the air: none; Preetham's formula, for the ground only; O'Neil's polynomial; Chapman's "
                  "function; a march; tables, which alone include multiple scattering; the reference"};
    Choice orders{*this,
                  "orders",
                  {"single", "multiple"},
                  "multiple",
                  "Orders of scattering: light scattered once, or any number of times"};
    Choice phase{*this,
                 "phase",
                 {"isotropic", "henyey_greenstein", "cornette_shanks"},
                 "cornette_shanks",
                 "Phase function of dust: isotropic, Henyey-Greenstein, or Cornette-Shanks"};
    Knob<int> steps{*this,
                    "steps",
                    16,
                    {1, 4096},
                    "Number of samples on the path of a pixel; the method truth takes 32 times as many"};
    Knob<int> light_steps{*this, "light_steps", 8, {1, 256}, "Number of samples from there to the sun (method march)"};
    Knob<int> paths{
        *this, "paths", 16, {1, 512}, "Number of random walks per pixel (method truth with orders multiple)"};
    Knob<float> table_scale{
        *this, "table_scale", 1.0f, {0.25f, 2.0f}, "Scale factor for the width and height of the tables"};
    Choice refresh{*this,
                   "refresh",
                   {"changed", "always"},
                   "changed",
                   "Recomputation of the tables: only after a change, or in every frame (for timing)"};

    Knob<float> sun_elevation_deg{
        *this,    "sun_elevation_deg", 30.0f, {-90.0f, 90.0f}, "Elevation of the sun, seen from the world origin",
        "degrees"};
    Knob<float> sun_azimuth_deg{
        *this, "sun_azimuth_deg", 0.0f, {-360.0f, 360.0f}, "Azimuth of the sun, from -z towards +x", "degrees"};
    Knob<float> sun_klx{*this, "sun_klx", 128.0f, {0.0f, 1e5f}, "Illuminance of the sun outside of the air", "klx"};
    Knob<glm::vec3> sun_color{
        *this, "sun_color", glm::vec3(1.0f), {glm::vec3(0.0f), glm::vec3(10.0f)}, "Colour of the sun, linear"};
    Knob<float> sun_deg{*this, "sun_deg", 0.53f, {0.01f, 20.0f}, "Angular diameter of the sun", "degrees"};
    Knob<float> disc{
        *this, "disc", 1.0f, {0.0f, 1.0f}, "Brightness of the sun's disc, as a fraction of its true brightness"};
    Knob<float> exposure{*this, "exposure", 0.1f, {0.0f, 1e6f}, "Exposure: scale factor for luminance in kcd/m²"};
    Knob<float> turbidity{
        *this, "turbidity", 2.5f, {1.0f, 20.0f}, "Turbidity of the air (method preetham): 2 is very clear, 10 is haze"};

    Knob<float> radius_m{*this, "radius_m", 6.36e6f, {1e3f, 1e9f}, "Radius of the planet", "m"};
    Knob<float> top_m{*this, "top_m", 1e5f, {1.0f, 1e8f}, "Height of the top of the air", "m"};
    Knob<glm::vec3> rayleigh{*this,
                             "rayleigh",
                             {5.802f, 13.558f, 33.1f},
                             {glm::vec3(0.0f), glm::vec3(1e5f)},
                             "Scattering coefficient of molecules at the ground",
                             "1/Mm"};
    Knob<float> rayleigh_height_m{*this, "rayleigh_height_m", 8000.0f, {0.0f, 1e6f}, "Scale height of molecules", "m"};
    Knob<glm::vec3> mie{*this,
                        "mie",
                        glm::vec3(3.996f),
                        {glm::vec3(0.0f), glm::vec3(1e5f)},
                        "Scattering coefficient of dust at the ground",
                        "1/Mm"};
    Knob<glm::vec3> mie_absorption{*this,
                                   "mie_absorption",
                                   glm::vec3(0.444f),
                                   {glm::vec3(0.0f), glm::vec3(1e5f)},
                                   "Absorption coefficient of dust at the ground",
                                   "1/Mm"};
    Knob<float> mie_height_m{*this, "mie_height_m", 1200.0f, {0.0f, 1e6f}, "Scale height of dust", "m"};
    Knob<float> mean_cosine{*this,
                            "mean_cosine",
                            0.8f,
                            {-0.95f, 0.95f},
                            "Mean cosine of the scattering angle of dust: 1 is straight ahead"};
    Knob<glm::vec3> ozone{*this,
                          "ozone",
                          {0.65f, 1.881f, 0.085f},
                          {glm::vec3(0.0f), glm::vec3(1e5f)},
                          "Absorption coefficient at the centre of the ozone layer; 0: no layer",
                          "1/Mm"};
    Knob<float> ozone_center_m{
        *this, "ozone_center_m", 25000.0f, {0.0f, 1e7f}, "Height of the centre of the ozone layer", "m"};
    Knob<float> ozone_width_m{*this, "ozone_width_m", 15000.0f, {0.0f, 1e7f}, "Half width of the ozone layer", "m"};
    Knob<glm::vec3> ground{*this,
                           "ground",
                           glm::vec3(0.1f),
                           {glm::vec3(0.0f), glm::vec3(1.0f)},
                           "Albedo of the ground, for the light it reflects into the air"};

    Phase draw_phase() const override { return Phase::air; }
    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }
    void update_sun() override;
    /// Ground lighting under this air, for sunlight_on() and skylight_on().
    void update(Frame& frame) override;
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

    /// At the world's origin, exposed: the value of update_sun().
    Sun sun();

    glm::vec3 to_sun() const;  ///< unit length, world space
    Air air() const;           ///< the knobs, as shaders read them

    void bind(Pass& pass) const override;

    /// Of the frame recorded last, to look at: "transmittance", "multiple" or "sky" of the method tables, and "doubt" of
    /// truth; null: none of this name for this method.
    const Image* table(std::string_view name) const;

    /// With `truth` for many scatterings: the standard error of each pixel's light, over the light.
    const Image& doubt() const { return doubt_; }

    int tables_made = 0, skies_made = 0;  ///< so far, to show that none is made twice

  private:
    Scene* scene_ = nullptr;
    void make_images(Device& device);
    void record_tables(Frame& frame, const View& view, float reach_m);
    std::vector<PathPart> parts() const;
    float height_of(glm::vec3 position) const;
    float mie_g() const;
    mutable std::optional<std::pair<float, float>> mie_g_;  ///< mean_cosine and its g: each pass asks
    float volume_reach_m(const Camera& camera) const;

    Buffer skylight_;
    bool skylight_uploaded_ = false;  ///< as the table is now
    SkylightTable sky_table_;
    Fingerprint sun_made_;
    glm::vec3 sunlight_{0.0f};
    Image light_so_far_, through_so_far_, doubt_, sky_, light_, through_;
    AirTables lasting_;
    Fingerprint sky_made_;
    Pipeline make_sky_ = compute({.shader = "10_atmosphere/make_sky.comp"});
    Pipeline make_aerial_ = compute({.shader = "10_atmosphere/make_aerial.comp"});
    Pipeline none_ = compute({.shader = "10_atmosphere/look_none.comp"});
    Pipeline preetham_ = compute({.shader = "10_atmosphere/look_preetham.comp"});
    Pipeline polynomial_ = compute({.shader = "10_atmosphere/look_closed.comp", .macros = {{"ONEIL", "1"}}});
    Pipeline chapman_ = compute({.shader = "10_atmosphere/look_closed.comp"});
    Pipeline march_ = compute({.shader = "10_atmosphere/look_march.comp"});
    Pipeline march_parts_ = compute({.shader = "10_atmosphere/look_march.comp", .macros = {{"IN_PARTS", "1"}}});
    Pipeline look_tables_ = compute({.shader = "10_atmosphere/look_tables.comp"});
    Pipeline truth_ = compute({.shader = "10_atmosphere/look_truth.comp"});
};

/// The parameter g with which Cornette and Shanks' function has that mean cosine (-0.95 to 0.95). At equal g its mean
/// cosine is larger than Henyey and Greenstein's, which is g.
float cornette_shanks_g(float mean_cosine);

}  // namespace lightwalk
