// Parts of the editor's window: fields, files, settings, tree, properties, loading, tour; and what they share.
#pragma once
#include <chrono>
#include <deque>
#include <functional>
#include <map>

#include "15_terrain_water/ground.h"
#include "18_playground/background_load.h"
#include "18_playground/placement.h"
#include "18_playground/playground.h"
#include "18_playground/preview.h"
#include "18_playground/properties.h"
#include "common/base/epoch.h"
#include "common/scene/pick.h"
#include "common/scene/view.h"
#include "common/window/window_tool.h"

namespace lightwalk {

/// The picture beside the panels, and the panels' requests to the window.
struct EditorView {
    Playground& chapter;
    Gpu* gpu = nullptr;                          ///< of the frames
    Area picture{{0, 0}, {960, 540}};            ///< of the window
    std::optional<glm::vec2> pointer;            ///< over the picture, in its pixels
    bool changed = false;                        ///< the picture has to be drawn again
    AutoChoices* automatic;                      ///< the window's, for knobs in panels
    std::function<void(const KeyPress&)> press;  ///< a key's action, for menus
    GroundHeights terrain() const { return gpu ? read_heights(*gpu, chapter.bench.ground) : GroundHeights{}; }
    /// Lets the person choose an image file for `what`.
    std::function<void(const std::string& what, const std::function<void(const std::filesystem::path&)>& take)> pick;
};

inline double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Through what the pointer shows, or the middle of the picture.
inline PickRay placing_ray(const EditorView& view) {
    const View& now = view.chapter.view_now;
    if (now.size.x == 0) return {};
    return ray_through(now, view.pointer.value_or(0.5f * glm::vec2(now.size)));
}

/// A part of the window. It owns its state; the document and the scene belong to the editor.
class EditorPart {
  public:
    explicit EditorPart(EditorView& view) : view_(view), editor(view.chapter.editor), scene(view.chapter.scene) {}
    EditorPart(const EditorPart&) = delete;

  protected:
    void say(const Said& said) {
        if (!said.empty()) editor.notice = said;
    }
    EditorView& view_;
    Editor& editor;
    Scene& scene;
};

/// Numbers, colours, switches and lists. `mixed`: a dash stands for differing values of several entries. True if the
/// value was changed.
class EditorFields : public EditorPart {
  public:
    using EditorPart::EditorPart;

    /// `most`: a word for the largest value, which stands for no limit.
    bool number(const char* label, const char* help, float& value, float speed, float lower, float upper,
                bool mixed = false, const char* most = "%.5g");
    bool numbers(const char* label, const char* help, glm::vec3& value, float speed,
                 glm::bvec3 mixed = glm::bvec3(false));
    bool color(const char* label, const char* help, glm::vec3& value, float most, glm::bvec3 mixed = glm::bvec3(false));
    bool check(const char* label, const char* help, bool& on, bool mixed);
    bool choice(const char* label, std::initializer_list<const char*> names, float& index, bool mixed);

    /// A refusal is reported once while a number is dragged, although it recurs each frame.
    void refuse(const Said& said) {
        if (std::exchange(refused_, said) != said) say(said);
    }

    void begin_frame();  ///< before the first field
    bool drags() const { return drags_; }
    /// All that a drag over a number has changed. The mouse may still be held: it drags no more.
    void take_drag_back();

  private:
    bool once_left(
        uint32_t field, float* values, int count, const std::function<bool()>& widget,
        const std::function<bool()>& has_list = [] { return false; });
    bool three_numbers(glm::vec3& value, float right, float speed, float lower, float upper, glm::bvec3 mixed);
    bool takes(const char* label, float* values, int count, const float* before, float lower, float upper);

    /// Numbers that somebody types.
    struct Typed {
        uint32_t item = 0;  ///< within the field
        int frame = -1;     ///< that has drawn it last
        glm::vec3 values{0.0f};
    };
    std::map<uint32_t, Typed> typed_;  ///< by field: where one is left for another, both are there for a frame
    std::string refused_;
    bool drags_ = false, stops_drag_ = false;  ///< with the mouse, in the frame drawn last; the next one ends it
};

class SceneFiles : public EditorPart {
  public:
    using EditorPart::EditorPart;

    void save(bool overwrite = false);
    void ask_name();  ///< saves to the file whose name is then typed
    void save_as();   ///< to the file that `name` says
    void ask_export();
    void export_due();  ///< when the scene matches the document: two keys may come in one frame
    bool may_close();
    bool closes() const { return closes_; }
    void keep_time();  ///< once per frame: looks for a crash's autosave, and saves every 30 s

    bool asks() const { return asked_.what != Question::nothing; }
    void answer(int key) { asked_.key = key; }  ///< GLFW_KEY_..., pressed since it was asked
    void draw_question();

    std::string name = "scene.json";  ///< of a scene that has none, or is not written over

  private:
    enum class Question { nothing, name, close, overwrite, recover, export_over };
    std::string question_text(Question asked) const;
    void draw_answers(Question asked, int pressed);
    void draw_name(int pressed);
    bool saves_own() const;
    std::filesystem::path save_target() const;
    std::filesystem::path export_target() const;
    void check_recovery();
    struct {
        Question what = Question::nothing;
        int key = 0;
        bool begins = false;  ///< the next frame puts the keyboard into its field
    } asked_;
    bool saves_as_ = false, exports_ = false, closes_ = false;
    std::filesystem::path exported_;                ///< last export, which may be overwritten
    std::optional<std::filesystem::path> checked_;  ///< the scene of which a crash may have left something
    double next_autosave_ = 0;
};

/// They stand in the tree before all others, and are edited where an entry's properties are.
class SettingsPanel : public EditorPart {
  public:
    SettingsPanel(EditorView& view, EditorFields& fields, SceneFiles& files)
        : EditorPart(view), fields_(fields), files_(files) {}

    void draw_rows();  ///< in the tree
    void draw();
    static std::vector<std::string> names();
    /// Light from all around, of an image; empty: none.
    void put_environment(const std::string& image);
    /// A height map's ground below the scene, under a sky; empty: none.
    void put_terrain(const std::string& file);

    std::string chosen;  ///< one of names(); empty: the scene itself

  private:
    bool is_there(const std::string& name) const;
    void draw_knobs();
    bool draw_camera(SceneSettings& settings);
    void draw_output_shape();
    bool draw_environment(SceneSettings& settings);
    void draw_terrain();
    void set(const std::string& what, const SceneSettings& settings);
    EditorFields& fields_;
    SceneFiles& files_;
};

class TreePanel : public EditorPart {
  public:
    TreePanel(EditorView& view, SettingsPanel& settings) : EditorPart(view), settings_(settings) {}

    void draw();
    void begin_renaming(EntryId id);
    void begin_search() { searches_ = true; }
    void walk(int by);  ///< selects the entry so many rows further down
    void unfold_chosen(bool open);
    void give_up_fields();  ///< none is there to wait for the keyboard

  private:
    void draw_row(const TreeRow& row);
    void draw_name(const TreeRow& row);
    void draw_name_field(EntryId id);
    void choose(EntryId id);
    void drag_and_drop(EntryId id, const std::string& shown_as);
    void draw_menu(EntryId id);
    void draw_fold(const TreeRow& row);
    void draw_eye(EntryId id, bool hidden, const std::string& shown_as);
    SettingsPanel& settings_;
    std::string search_;
    bool folds_ = false;     ///< some entry has children
    bool searches_ = false;  ///< the next frame puts the keyboard into the field
    struct {
        EntryId id = no_entry;
        std::string text;
        bool begins = false;
    } renaming_;
    EntryId last_clicked_ = no_entry, followed_ = no_entry;  ///< followed_: last row scrolled to
};

class MaterialBall : public EditorPart {
  public:
    using EditorPart::EditorPart;

    /// Shows the picture drawn last. Another one is due where the material has changed and nobody drags.
    void draw(EntryId id, const DrawItem& item);
    bool is_due() const { return due_.has_value(); }
    void make();  ///< the picture that is due, beside the frames

    Preview preview;

  private:
    static constexpr uint32_t size = 88;  ///< pixels
    std::optional<SceneFile> due_;
    Fingerprint made_;
    Fingerprint files_;
    Image8 picture_;
};

class PropertiesPanel : public EditorPart {
  public:
    PropertiesPanel(EditorView& view, EditorFields& fields, SettingsPanel& settings, TreePanel& tree)
        : EditorPart(view), ball(view), fields_(fields), settings_(settings), tree_(tree) {}

    void draw();
    bool wants_keyboard = false;  ///< its first field gets it in the next frame
    MaterialBall ball;

    /// Of all these objects with a model; an empty file clears the map.
    void set_map(std::vector<EntryId> ids, const std::string& slot, const std::string& file);

  private:
    void draw_switches(EntryId id);
    void draw_object(EntryId id);
    void draw_offers(EntryId id);
    void draw_material(EntryId id);
    void draw_light();
    bool draw_field(const PropertyField& field, glm::vec3& value, glm::bvec3 mixed);
    /// A field of a property of together_: an edit applies to all of them.
    void edit(const Property& property);
    void edit_map(const std::string& slot);
    EditorFields& fields_;
    SettingsPanel& settings_;
    TreePanel& tree_;
    std::vector<EntryId> together_;  ///< entries being edited; the active one is the last
};

class LoadingPanel : public EditorPart {
  public:
    using EditorPart::EditorPart;

    void want(const std::filesystem::path& file, bool adds);
    bool loads() const { return !wanted_.empty(); }
    void cancel();
    /// Once per frame, also of those in which the window draws its panels only.
    void carry_on();
    void draw();

  private:
    /// A file that was asked for, and the models that it still needs.
    struct Wanted {
        std::filesystem::path file;
        bool adds = false;
        PickRay ray;  ///< to where it is placed
        std::vector<std::filesystem::path> models;
        std::vector<std::unique_ptr<Arrival>> arrived;
    };
    void stop(const std::string& why);
    Bounds box_of(const Wanted& wanted) const;
    std::deque<Wanted> wanted_;
    BackgroundLoad loading_;
};

/// A step is over once the person has done what it says. It is shown at the first start, and later on request.
class Tour : public EditorPart {
  public:
    static constexpr const char* scene = "scenes/terrace.json";

    /// Shown unless it was left before, which knob_sections.h keeps.
    explicit Tour(EditorView& view);

    void begin();
    bool shown() const { return step_ > 0; }
    float height_px(float scale) const { return shown() ? 156.0f * scale : 0.0f; }
    void draw(float width_px, float scale);

    /// What a step's end is told by.
    struct Facts {
        glm::vec3 camera{0.0f};
        size_t selected = 0, done = 0, objects = 0, lights = 0;
        Tool tool = Tool::move;
        bool sky = false, weather = false, saved = false;
    };

    /// Of step `step`, from 1 on: whether the person has done what it says since it began.
    static bool is_done(size_t step, const Facts& begin, const Facts& now);

  private:
    Facts facts() const;
    void go_to(size_t step);
    void leave();
    size_t step_ = 0;  ///< from 1 on; 0: not shown
    Facts begin_;      ///< of the step
};

struct Landing {
    glm::vec3 point{0.0f}, normal{0.0f, 1.0f, 0.0f};  ///< metres, world space; the normal points to the viewer
    float distance_m = 1;                             ///< from the eye
};

/// Behind the picture's edge, or far away, the ground below the scene; where there is none, a point at the distance of
/// the camera's target.
Landing landing_on(const Scene& scene, const Camera& camera, const PickRay& ray, const GroundHeights& terrain = {});

/// A model whose box touches the surface from outside. One that the view could not show keeps its shape, not its size.
Placement placed_model(const Landing& landing, const Camera& camera, const Bounds& box);

/// A lamp above the surface, halfway to what is opposite at most, in the picture, and at a place of its own.
Light placed_light(Light::Kind kind, const Landing& landing, const Scene& scene, const View& view);

}  // namespace lightwalk
