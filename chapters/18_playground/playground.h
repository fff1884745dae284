// The playground's picture: drawings and effects of all chapters, composed.
#pragma once
#include "01_obj/model_chapter.h"
#include "06_deferred/deferred_scene.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "10_atmosphere/height_fog.h"
#include "10_atmosphere/planet.h"
#include "13_mlaa/mlaa.h"
#include "14_environment/backdrop.h"
#include "14_environment/paint.h"
#include "14_environment/probe.h"
#include "14_environment/substances.h"
#include "15_terrain_water/water.h"
#include "18_playground/arrival.h"
#include "18_playground/editor.h"
#include "18_playground/marks.h"

namespace lightwalk {

struct Playground : ModelChapter {
    Choice air{*this, "air", {"none", "sky"}, "none", "Surroundings: those of the scene, or a sky with its sun (sky)"};
    Choice show{*this, "show", {"picture", "ids"}, "picture", "View: the picture, or what picking finds in each pixel"};
    Knob<int> select{*this, "select", -1, {-1, 1000000}, "Number of the object that is marked as selected; -1: none"};
    Knob<int> scattered{*this, "lights", 0, {0, 1000000}, "Number of random lights added to those of the scene"};

    ImageLight light{*this, "environment"};
    SceneProbe probe{*this, "probe"};  ///< of the sky
    Backdrop backdrop{*this, "backdrop", light};
    DeferredScene objects{*this, "objects"};
    Substances substances{*this, "substance"};
    CarPaint paint{*this, "paint"};
    Atmosphere atmosphere{*this, "atmosphere"};
    Planet sky{*this, "sky", atmosphere};
    Water water{*this, "water", light};
    HeightFog fog{*this, "fog"};
    Mlaa antialias{*this, "mlaa"};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};
    Picker picker{*this, "picker"};
    Marks marks{*this, "marks"};

    Editor editor;
    std::optional<std::filesystem::path> opens;     ///< a scene that the next frame shall open
    std::vector<std::unique_ptr<Arrival>> arrived;  ///< models for what the next frame adds or opens
    std::optional<glm::ivec2> click;                ///< a pixel that the next frame shall pick

    Playground();
    std::string default_scene() const override { return "scenes/workbench.json"; }
    void prepare(Gpu&, Scene&) override { editor.loaded(*this), updates_ = true; }
    void frame(Frame& frame) override;
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override;
    std::vector<std::string> status() const override;

    View view_now;  ///< of the frame that was drawn last

  protected:
    /// First in each frame.
    virtual void bring_up_to_date(Gpu& gpu);

  private:
    void draw_world(Frame& frame, const View& view);
    void draw_marks(Frame& frame, const View& view);
    void show_ids(Frame& frame);
    bool updates_ = false, maps_due_ = true;
    const Macros all_{{"LIGHTS_METHOD", "LIGHTS_METHOD_EVERY_LIGHT"}};
    SurfacePipelines surface_{{.fragment = "14_environment/surface.frag"}};
    SurfacePipelines glass_ = LitScene::see_through("14_environment/surface.frag", all_);
    SurfacePipelines write_{{.fragment = "18_playground/write.frag"}};
    SurfacePipelines rest_ = DeferredScene::added("18_playground/rest.frag", all_);
    Pipeline show_ids_ = compute({.shader = "18_playground/show_ids.comp"});
};

}  // namespace lightwalk
