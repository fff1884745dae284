// The playground: a workbench, picking and marks on it, and the document behind it.
#pragma once
#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "13_mlaa/mlaa.h"
#include "18_playground/arrival.h"
#include "18_playground/editor.h"
#include "18_playground/marks.h"
#include "18_playground/output_frame.h"
#include "18_playground/workbench.h"

namespace lightwalk {

struct Playground : ModelChapter {
    Choice show{*this, "show", {"picture", "ids"}, "picture", "View: the picture, or what picking finds in each pixel"};
    Knob<int> select{*this, "select", -1, {-1, 1000000}, "Number of the object that is marked as selected; -1: none"};
    Workbench bench{*this};
    DeferredScene& objects = bench.objects;
    Mlaa antialias{*this, "mlaa"};
    Bloom bloom{*this, "bloom"};
    Post post{*this, "post"};
    Picker picker{*this, "picker"};
    Marks marks{*this, "marks"};

    Editor editor;
    OutputFrame output_frame;
    std::optional<std::filesystem::path> opens;     ///< a scene that the next frame shall open
    std::vector<std::unique_ptr<Arrival>> arrived;  ///< models for the next frame to add or open
    std::optional<glm::ivec2> click;                ///< a pixel that the next frame shall pick

    Playground();
    std::string default_scene() const override { return "scenes/workbench.json"; }
    void prepare(Gpu&, Scene&) override {
        editor.loaded(*this);
        updates_ = true;
    }
    void frame(Frame& frame) override;
    void measure(Gpu& gpu, glm::uvec2 size, nlohmann::json& error) override;
    std::vector<std::string> status() const override;

    View view_now;  ///< of the frame that was drawn last

  protected:
    /// First in each frame.
    virtual void bring_up_to_date(Gpu& gpu);

  private:
    void draw_marks(Frame& frame, const View& view);
    void show_ids(Frame& frame);
    bool updates_ = false, maps_due_ = true;
    Pipeline show_ids_ = compute({.shader = "18_playground/show_ids.comp"});
};

}  // namespace lightwalk
