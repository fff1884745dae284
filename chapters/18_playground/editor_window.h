// The editor in a window: the playground with panels, the gizmo under the mouse, and keys.
#pragma once
#include <deque>

#include "18_playground/background_load.h"
#include "18_playground/file_browser.h"
#include "18_playground/playground.h"
#include "18_playground/properties.h"
#include "common/window/window_tool.h"

namespace lightwalk {

struct EditorWindow : Playground, WindowTool {
    bool on_mouse(const Input& input, glm::vec2 cursor_px, bool over_picture) override;
    bool on_key(const KeyPress& key) override;
    void on_drop(const std::vector<std::filesystem::path>& files) override;
    bool draw_panels(glm::uvec2 picture, float scale) override;
    float covered_px(glm::uvec2 picture, float scale) const override;
    bool on_save() override;
    void save_as() { saves_as_ = true, on_save(); }  ///< to the file that the field names
    bool may_close() override;
    bool wants_to_close() override { return closes_; }
    bool is_busy() override;
    std::string take_notice() override { return clean_name(std::exchange(editor.notice, "")); }

  protected:
    void bring_up_to_date(Gpu& gpu) override;

  private:
    void draw_tree();
    void draw_row(const TreeRow& row);
    void begin_renaming(EntryId id);
    void draw_properties();
    void draw_switches(EntryId id);
    void draw_object(EntryId id);
    void draw_material(EntryId id);
    void draw_light(EntryId id);
    void draw_settings();
    void draw_row_menu(EntryId id);
    void draw_steps(float scale);
    void draw_toolbar();
    void draw_question();
    void draw_keys(float scale);
    bool on_control_key(const KeyPress& key);
    bool on_shift_key(int key);
    void choose_at(glm::vec2 cursor_px, bool add);
    void walk_tree(int by);
    void unfold_chosen(bool open);
    void scatter_lights();
    bool once_left(
        uint32_t field, float* values, int count, const std::function<bool()>& widget,
        const std::function<bool()>& has_list = [] { return false; });
    bool three_numbers(glm::vec3& value, float right, float speed, float lower, float upper, glm::bvec3 mixed);
    bool takes(const char* label, float* values, int count, const float* before, float lower, float upper);
    // Fields; `mixed`: a dash stands for what is not the same in several entries.
    bool number(const char* label, const char* help, float& value, float speed, float lower, float upper,
                bool mixed = false);
    bool numbers(const char* label, const char* help, glm::vec3& value, float speed,
                 glm::bvec3 mixed = glm::bvec3(false));
    bool color(const char* label, const char* help, glm::vec3& value, float most, glm::bvec3 mixed = glm::bvec3(false));
    bool check(const char* label, const char* help, bool& on, bool mixed);
    bool choice(const char* label, std::initializer_list<const char*> names, float& index, bool mixed);
    /// A field of a property of together_: what is edited there is set in all of them.
    void edit(const Property& property, const std::function<bool(glm::vec3& value, glm::bvec3 mixed)>& field);
    void edit_number(const Property& property, const char* label, const char* help, float speed, float lower,
                     float upper);
    void edit_numbers(const Property& property, const char* label, const char* help, float speed);
    void edit_color(const Property& property, const char* label, const char* help, float most);
    void edit_map(const std::string& slot);
    void say(const Said& said) {
        if (!said.empty()) editor.notice = said;
    }
    /// As say(), but once while a number is dragged over what is refused: it is asked in each frame.
    void refuse(const Said& said) {
        if (std::exchange(refused_, said) != said) say(said);
    }
    void want(const std::filesystem::path& file, bool adds);
    void carry_on_loading(Gpu& gpu);
    void stop_loading(const std::string& why);
    void draw_loading(float scale);
    void draw_facets();
    void draw_facet();
    void draw_facet_settings();
    bool has_facet(const std::string& name) const;
    static std::vector<std::string> facet_names();
    void draw_ball(EntryId id, const DrawItem& item);
    void carry_on_previews();
    void set_settings(const std::string& what, const SceneSettings& settings);
    void frame_selected();
    void take_number_back();
    void check_recovery();
    bool saves_own() const;
    std::filesystem::path save_target() const;
    std::filesystem::path export_target() const;
    void on_export();
    void export_now();

    enum class Question { nothing, close, overwrite, recover, export_over } question_ = Question::nothing;
    int answer_key_ = 0;  ///< GLFW_KEY_..., pressed since it was asked
    FileBrowser browser_{*this};
    /// A file that was asked for, and the models that it still needs.
    struct Wanted {
        std::filesystem::path file;
        bool adds = false;
        std::vector<std::filesystem::path> models;
        std::vector<std::unique_ptr<Arrival>> arrived;
    };
    std::deque<Wanted> wanted_;
    /// What loading costs the frames that are drawn meanwhile, up to the first one that shows all of it.
    struct Pace {
        double since = 0, last = 0, longest_s = 0, own_longest_s = 0;
        int frames = 0;
        bool shown = false;  ///< the frame before has shown what was loaded
    };
    std::optional<Pace> pace_;
    void note_pace(double start, double own_s);
    void load_beside_the_picture();
    BackgroundLoad loading_;
    Gpu* gpu_ = nullptr;  ///< of the frames
    Preview preview_;
    std::optional<SceneFile> ball_scene_;  ///< that is still to be drawn
    std::string ball_key_;
    const ImagePool* ball_of_ = nullptr;  ///< of the scene that it was drawn for
    Image8 ball_;
    static constexpr uint32_t ball_size = 88;  ///< pixels
    std::string facet_;                        ///< of the scene: its entry in the tree; empty: the scene itself
    std::string refused_, search_, renaming_text_, save_name_ = "scene.json";
    /// Numbers that somebody types.
    struct Typed {
        uint32_t item = 0;  ///< within the field
        int frame = -1;     ///< that has drawn it last
        glm::vec3 values{0.0f};
    };
    std::map<uint32_t, Typed> typed_;  ///< by field: where one is left for another, both are there for a frame
    std::vector<EntryId> together_;    ///< whose properties are edited; the active entry is the last
    EntryId renaming_ = no_entry, last_clicked_ = no_entry, followed_ = no_entry;  ///< whose line was scrolled to last
    bool drags_number_ = false, stops_drag_ = false;  ///< with the mouse, in the frame drawn last; the next one ends it
    size_t listed_ = SIZE_MAX;                        ///< the step that the list was scrolled to last
    bool types_ = false, searches_ = false;           ///< the next frame puts the keyboard into a field
    bool renaming_begins_ = false, closes_ = false, shows_keys_ = false, shows_steps_ = false, changed_ = false,
         overwrites_ = false, saves_as_ = false, exports_ = false;
    std::filesystem::path exported_;  ///< what was written last, and may be written over
    bool was_down_ = false, pressed_on_picture_ = false, dragged_ = false, adds_ = false;
    std::optional<std::filesystem::path> checked_;  ///< the scene of which a crash may have left something
    glm::vec2 press_px_{0.0f};
    float moved_px_ = 0;
    double next_autosave_ = 0;
    int scatter_count_ = 100;
    glm::uvec2 picture_{960, 540};
    float covered_px_ = 0;  ///< of it, by the panel on the left
};

}  // namespace lightwalk
