// The editor in a window: the playground with panels, the gizmo under the mouse, and keys.
#pragma once
#include "18_playground/file_browser.h"
#include "18_playground/playground.h"
#include "common/window/window_tool.h"

namespace lightwalk {

struct EditorWindow : Playground, WindowTool {
    bool on_mouse(const Input& input, glm::vec2 cursor_px, bool over_picture) override;
    bool on_key(const KeyPress& key) override;
    void on_drop(const std::vector<std::filesystem::path>& files) override;
    bool draw_panels(glm::uvec2 picture, float scale) override;
    bool on_save() override;
    bool may_close() override;
    bool wants_to_close() override { return closes_; }
    bool is_busy() override;
    std::string take_notice() override { return std::exchange(editor.notice, ""); }

  private:
    void draw_tree();
    void draw_row(const TreeRow& row);
    void draw_properties();
    void draw_object(EntryId id);
    void draw_material(EntryId id);
    void draw_light(EntryId id);
    void draw_settings();
    void draw_steps();
    void draw_toolbar();
    void draw_question();
    void draw_keys();
    void say(const Said& said) {
        if (!said.empty()) editor.notice = said;
    }
    void add_file(const std::filesystem::path& file);
    template <class Change>
    void change(EntryId id, const char* what, const Change& set);
    void frame_selected();
    void check_recovery();

    enum class Question { nothing, close, overwrite, recover } question_ = Question::nothing;
    FileBrowser browser_{*this};
    std::string search_, renaming_text_, save_name_ = "scene.json";
    EntryId renaming_ = no_entry, last_clicked_ = no_entry;
    bool closes_ = false, shows_keys_ = false, shows_steps_ = false, changed_ = false, overwrites_ = false;
    bool was_down_ = false, pressed_on_picture_ = false, adds_ = false, checked_recovery_ = false;
    glm::vec2 press_px_{0.0f};
    float moved_px_ = 0;
    double next_autosave_ = 0;
    int scatter_count_ = 100;
    glm::uvec2 picture_{960, 540};
};

}  // namespace lightwalk
