// The film as a chapter: the picture at a time. It knows no window; film_window.h puts the timeline's strip over it.
#pragma once
#include "01_obj/model_chapter.h"
#include "05_shadow_maps/lit_scene.h"
#include "09_post_effects/post.h"
#include "13_mlaa/mlaa.h"
#include "19_ambiance/film_out.h"
#include "19_ambiance/reel.h"

namespace lightwalk {

struct Ambiance : ModelChapter {
    Choice method{
        *this,
        "method",
        {"as_set", "linear", "catmull_rom", "centripetal", "smooth_speed", "arc_length", "exact"},
        "as_set",
        "Path of cameras: as the film says; straight lines; uniform or centripetal Catmull-Rom; that with a speed that "
        "does not jump at keys; at an even speed by a table of 64 lengths, or of 1,024 (the reference)"};
    Knob<float> smoothed{*this,
                         "smoothed",
                         1.0f,
                         {0.0f, 1.0f},
                         "Share of the anti-aliased picture; the rest is the picture as it was drawn"};
    Reel reel{*this, "reel"};
    LitScene objects{*this, "objects"};  // of a scene that is no film
    Mlaa antialias{*this, "mlaa"};
    Post post{*this, "post"};
    FilmOut out{*this, "out"};

    Ambiance();
    std::string default_scene() const override { return "films/ambiance.film"; }
    void prepare_frame(Gpu& gpu, glm::uvec2 size, float time_s) override;
    void frame(Frame& frame) override;
    float gathered_at(float time_s, int frames_before) const override;

    /// For the study: how far the camera is from its reference path, and how evenly it moves.
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override;

  private:
    void smooth_edges(Frame& frame, const Seen& seen);
    void make_effects(Gpu& gpu) const;
    Target jagged_{*this, {.name = "jagged", .kept = true}};
    Pipeline copy_ = compute({.shader = "19_ambiance/copy.comp"}), mix_ = compute({.shader = "19_ambiance/mix.comp"});
};

}  // namespace lightwalk
