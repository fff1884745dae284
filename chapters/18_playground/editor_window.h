// The editor in a window: the playground with panels, the gizmo under the mouse, and keys.
#pragma once
#include "18_playground/editor_part.h"
#include "18_playground/file_browser.h"

namespace lightwalk {

class EditorPointer : public EditorPart {
  public:
    using EditorPart::EditorPart;

    /// True: taken, and the camera stays.
    bool move(const Input& input, glm::vec2 cursor_px, bool over_picture);
    std::vector<std::string> words() const;  ///< what a drag does from here; none: it moves the camera

  private:
    void take_picked();
    bool drag(const Input& input, glm::vec2 cursor_px, bool released);
    void choose_at(glm::vec2 cursor_px, bool add);
    bool was_down_ = false, pressed_on_picture_ = false, dragged_ = false, adds_ = false;
    glm::vec2 press_px_{0.0f};
    float moved_px_ = 0;
    Tool tool_ = Tool::move;  ///< of the gizmo: a sun is turned only
};

/// A click goes back or forward to where a step was done.
class StepsPanel : public EditorPart {
  public:
    using EditorPart::EditorPart;
    void draw();
    bool shown = false;

  private:
    size_t listed_ = SIZE_MAX;  ///< the step that the list was scrolled to last
};

class KeysPanel : public EditorPart {
  public:
    KeysPanel(EditorView& view, std::function<void()> tour) : EditorPart(view), tour_(std::move(tour)) {}
    void draw();
    bool shown = false;

  private:
    std::function<void()> tour_;  ///< begins it
};

/// It places its panels, each of which owns its state, and gives them the keys: one member for each of them.
struct EditorWindow : Playground, WindowTool {
    EditorWindow();
    bool on_mouse(const Input& input, glm::vec2 cursor_px, bool over_picture) override;
    bool on_key(const KeyPress& key) override;
    void on_drop(const std::vector<std::filesystem::path>& files) override;
    bool draw_panels(const Area& picture, float dock_px, float scale) override;
    int dock_width() const override { return 310; }
    std::vector<std::string> mouse_words() const override { return pointer_.words(); }
    std::string document() const override {
        return clean_name((editor.store.path.empty() ? "untitled" : editor.store.path.filename().string()) +
                          (editor.store.has_unsaved(editor.document) ? " *" : ""));
    }
    bool on_save() override;
    bool may_close() override { return files_.may_close(); }
    bool wants_to_close() override { return files_.closes(); }
    bool is_busy() override;
    std::string take_notice() override { return clean_name(std::exchange(editor.notice, "")); }

  protected:
    void bring_up_to_date(Gpu& gpu) override;

  private:
    bool on_control_key(const KeyPress& key);
    bool on_shift_key(int key);
    bool on_escape();
    bool leaves();
    void draw_toolbar();
    void draw_lights_toolbar();
    void draw_dock(float width_px, float scale);
    /// Files, steps or keys stand where the tree is otherwise.
    bool shows_list() const { return browser_.shown || steps_.shown || keys_.shown; }
    void show_list(bool& which, bool shown) {
        browser_.close();
        steps_.shown = keys_.shown = false;
        which = shown;
    }
    void carry_on_previews();
    void scatter_lights();
    void add_light(Light::Kind kind);
    void choose_file(const std::filesystem::path& file, bool adds);
    void take_dropped();
    void frame_selected();

    EditorView view_{.chapter = *this, .automatic = nullptr, .press = {}, .pick = {}};
    EditorFields fields_{view_};
    SceneFiles files_{view_};
    SettingsPanel settings_{view_, fields_, files_};
    TreePanel tree_{view_, settings_};
    PropertiesPanel properties_{view_, fields_, settings_, tree_};
    LoadingPanel loading_{view_};
    EditorPointer pointer_{view_};
    StepsPanel steps_{view_};
    Tour tour_{view_};
    KeysPanel keys_{view_, [this] { tour_.begin(); }};
    FileBrowser browser_;
    int scatter_count_ = 100;
    std::optional<Camera> own_camera_;  ///< the scene's, in the frame drawn last
    bool leaving_ = false;              ///< the last key was an Escape with nothing to end
};

}  // namespace lightwalk
