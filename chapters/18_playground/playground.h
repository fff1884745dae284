// The playground: a workbench, picking and marks on it, and the document behind it.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "01_obj/model_chapter.h"
#include "08_bloom/bloom.h"
#include "09_post_effects/post.h"
#include "13_mlaa/mlaa.h"
#include "18_playground/background_load.h"
#include "18_playground/editor.h"
#include "18_playground/marks.h"
#include "18_playground/picker.h"
#include "18_playground/workbench.h"
#include "common/scene/camera.h"
#include "common/window/blit.h"

namespace lightwalk {

class OutputFrame {
  public:
    /// Names of shapes, the window's own first.
    static const std::vector<const char*>& names();

    size_t shape = 0;  ///< of names()

    /// The camera that shows all of the output in a picture of `size` pixels: where that is narrower, it sees more.
    Camera seen(const Camera& camera, glm::uvec2 size) const;
    /// The output in that picture.
    Area area(glm::uvec2 size) const;

    /// Darkens what is outside of it. `picture` in the window.
    void draw(const Area& picture, float scale) const;
};

struct Playground;

/// Adds `wrong_picks` to `error`: the share of pixels in which the method finds another item than the one that covers
/// most of the pixel, as 64 samples with cutouts see it. Where two items cover a pixel within an eighth of each other,
/// either is right.
void measure_picking(Playground& chapter, Gpu& gpu, glm::uvec2 size, nlohmann::json& error);

/// Of `fine`, ids at `times` the size, the share of pixels of `found` that are wrong.
double wrong_picks(const std::vector<uint32_t>& found, const std::vector<uint32_t>& fine, glm::uvec2 size,
                   uint32_t times);

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
