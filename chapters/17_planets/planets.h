// Planets module: the Sun, nine bodies around it and the Moon, at their true sizes and distances.
#pragma once
#include <optional>

#include "10_atmosphere/air_tables.h"
#include "10_atmosphere/skylight.h"
#include "17_planets/maps.h"
#include "common/app/drawing.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Air around bodies, for shaders of chapter 10.
struct BodyAir : Module {
    BodyAir(Module& owner, std::string name) : Module(owner, std::move(name), "atmosphere") {}
    Choice method{*this,
                  "method",
                  {"closed", "tables", "truth"},
                  "tables",
                  "Light of the Earth's air: sunlight by a formula; chapter 10's tables of sunlight and of multiple "
                  "scattering; the reference, with 32 times as many samples and random walks"};
    Choice orders{*this,
                  "orders",
                  {"single", "multiple"},
                  "multiple",
                  "Orders of scattering in the Earth's air: light scattered once, or any number of times, which the "
                  "method closed imitates by a fade to grey towards the night"};
    Choice phase{*this,
                 "phase",
                 {"isotropic", "henyey_greenstein", "cornette_shanks"},
                 "cornette_shanks",
                 "Phase function of dust: isotropic, Henyey-Greenstein, or Cornette-Shanks"};
    Knob<int> paths{*this, "paths", 4, {1, 16}, "Number of random walks per pixel of the Earth's air (method truth)"};
};

/// Draws over the background (the stars), where no depth was drawn. Scenes place the camera in metres from the centre
/// of the body `at`; +z points from it to the Sun (the Sun's own to the Earth) and +y as far north as that allows.
struct Planets : Drawing {
    Planets(Module& owner, std::string name);

    Choice at{*this, "at", body_names(), "saturn", "Body at the origin of the scene"};
    Choice method{
        *this,
        "method",
        {"own", "lambert", "wrapped", "lommel_seeliger", "minnaert", "hapke"},
        "own",
        "Law of reflection: each body's own, or one for all: Lambert, wrapped Lambert, Lommel-Seeliger, Minnaert, "
        "Hapke (the reference for airless bodies)"};
    Choice rings{
        *this,
        "rings",
        {"alpha", "tables", "single_scattering", "random_walks"},
        "single_scattering",
        "Light of rings: a painted disc; three tables (back, forward, unlit); single scattering and a fit of the rest; "
        "single scattering and random walks (the reference)"};
    Choice flow{
        *this,
        "flow",
        {"frozen", "scrolled", "nearest", "cross_fade", "two_frames", "advected"},
        "two_frames",
        "Jupiter's clouds: at rest, all at one speed, the nearest frame, two frames mixed, two moved frames mixed, or "
        "carried in 64 steps (the reference)"};
    Choice flow_frames{
        *this,
        "flow_frames",
        {"one", "five"},
        "one",
        "Frames of Jupiter's clouds: its map alone, or five maps a day apart, carried by the winds and by five "
        "more vortices"};
    Knob<int> walks{*this, "walks", 128, {1, 1024}, "Random walks per pixel of rings, for their reference"};
    Choice shadow{
        *this,
        "shadow",
        {"sphere", "hard", "disc"},
        "disc",
        "Shadows of bodies: of a ball with a hard edge, of the flattened body with a hard edge, or in the light "
        "of the Sun's disc (the reference)"};
    Choice show{*this,
                "show",
                {"bodies", "laws"},
                "bodies",
                "Image shown: all bodies, or the body at the origin four times, by Lambert, wrapped, Lommel-Seeliger "
                "and Hapke"};
    Choice maps{*this,
                "maps",
                {"near", "all"},
                "near",
                "Maps loaded: those of the body at the origin and of its companion, or of all bodies"};
    Knob<float> away{
        *this,
        "away",
        1.0f,
        {1e-3f, 1e6f},
        "Scale factor for the camera's distance from the body at the origin, where a scene's metres do not reach"};
    Knob<float> date_days{*this, "date_days", 6500.0f, {-36525.0f, 36525.0f}, "Date: days since 1 January 2000, 12:00",
                          "d"};
    Knob<float> days_per_s{*this, "days_per_s", 0.0f, {-3650.0f, 3650.0f}, "Days that pass in a second", "d/s"};
    Knob<float> turn_deg{
        *this, "turn_deg", 0.0f, {-360.0f, 360.0f}, "Further rotation of the body at the origin, eastwards", "degrees"};
    Knob<float> exposure{*this,
                         "exposure",
                         1.0f,
                         {0.0f, 1e6f},
                         "Exposure: radiance of a white surface that faces the Sun, at the body at the origin"};
    Knob<float> sun{*this, "sun", 60.0f, {0.0f, 6e4f}, "Largest radiance of the Sun's disc"};
    Knob<float> relief{*this, "relief", 1.0f, {0.0f, 4.0f}, "Scale factor for the slopes of the ground"};
    Choice parallax{*this,
                    "parallax",
                    {"none", "offset", "march", "truth"},
                    "none",
                    "Parallax of the ground: none, by the height where the ray meets the ball, in layers with a secant "
                    "in the last, or in 512 layers and 12 bisections (the reference)"};
    Knob<int> parallax_steps{*this, "parallax_steps", 16, {1, 256}, "Number of layers of parallax (method march)"};
    Knob<float> height_m{*this, "height_m", 8e3f, {0.0f, 5e4f}, "Height of the highest ground, for parallax", "m"};
    Knob<float> clouds{*this, "clouds", 1.0f, {0.0f, 1.0f}, "Opacity of the Earth's clouds"};
    Knob<float> night{*this, "night", 0.05f, {0.0f, 1e3f}, "Radiance of the Earth's cities by night"};
    Knob<float> waves{*this, "waves", 0.16f, {0.02f, 1.0f}, "Standard deviation of the slopes of the Earth's waves"};
    Knob<float> ring_exposure{
        *this,
        "ring_exposure",
        1.0f,
        {0.0f, 1e3f},
        "Exposure of rings over that of their planet: above 1 as in pictures composed of a short and a long exposure"};
    Knob<int> air_steps{*this, "air_steps", 10, {1, 256}, "Number of samples on a ray through air"};
    Knob<float> flow_days{*this, "flow_days", 0.0f, {-1e5f, 1e5f}, "Time since Jupiter's map was photographed", "d"};
    Knob<float> flow_period_days{*this,
                                 "flow_period_days",
                                 2.0f,
                                 {0.01f, 100.0f},
                                 "Time between two frames of Jupiter's clouds; 1, 2 or 4 of five frames",
                                 "d"};
    BodyAir air{*this, "air"};

    void prepare(Gpu& gpu, Scene&) override;
    std::string load_key() const override { return at.text() + " " + maps.text() + " " + flow_frames.text(); }
    std::vector<std::string> load_exercises() const override { return {"17.overlay_normals"}; }
    bool animated() const override { return days_per_s != 0.0f || at.is("sun"); }
    void draw(Frame& frame, const View& view, Canvas& canvas) override;

    /// Where the view looks from and how its axes stand in the world of the orbits. The view says the first itself where it has
    /// View::exact_eye; its axes are then the world's.
    struct Outlook {
        double days = 0;
        glm::dvec3 eye_m{0.0};
        glm::dmat3 to_view{1.0};
    };
    Outlook outlook(const Frame& frame, const View& view) const;

    /// The date, at a time of the chapter's clock.
    double days_at(double time_s) const {
        return static_cast<double>(date_days) + time_s * static_cast<double>(days_per_s);
    }

    /// Set by a flight: the distance from the Sun, in metres, at which `exposure` applies.
    std::optional<double> exposed_for_m;

  private:
    struct Shown {
        BodyId body;
        glm::mat4 placed;  ///< from its own axes to the view's, the camera at the origin
        int law = 0;       ///< 0: as the knob says
    };
    std::vector<Shown> shown(const Outlook& outlook) const;
    BodyNow now(const Shown& one, const Outlook& outlook, const Frame& frame, const View& view) const;
    void draw_body(Frame& frame, const View& view, Canvas& canvas, const Shown& one, const Outlook& outlook);
    BodyId body_at() const { return static_cast<BodyId>(at.index); }

    std::unique_ptr<ImagePool> pool_;
    std::map<BodyId, BodyMaps> maps_;
    std::shared_ptr<Image> white_, flat_;
    Buffer skylight_;
    SkylightTable sky_table_;
    AirTables air_tables_;  ///< of the Earth
    /// A body's resources are the same at any size in the picture.
    struct Drawn {
        Pipeline large, small;
    };
    static Drawn drawn_with(const Macros& parts) {
        return {compute({.shader = "17_planets/body.comp", .macros = parts}),
                compute({.shader = "17_planets/small_body.comp", .macros = parts})};
    }
    Drawn rock_ = drawn_with({});
    Drawn clouded_ = drawn_with({{"BODY_AIR", "1"}});
    Drawn earth_ = drawn_with({{"BODY_AIR", "1"}, {"BODY_EARTH", "1"}});
    Drawn earth_tables_ = drawn_with(Macros{{"BODY_AIR", "1"}, {"BODY_EARTH", "1"}}.replace_file(
        "10_atmosphere/sun_closed.glsl", "10_atmosphere/sun_table.glsl"));
    Drawn flowing_ = drawn_with({{"BODY_FLOW", "1"}});
    Drawn ringed_ = drawn_with({{"BODY_RINGS", "1"}});
    Drawn star_ = drawn_with({{"BODY_STAR", "1"}});
};

}  // namespace lightwalk
