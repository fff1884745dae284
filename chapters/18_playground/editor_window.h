// The editor in a window: the playground with panels, the gizmo under the mouse, and keys.
#pragma once
#include "18_playground/editor_lists.h"
#include "18_playground/editor_loading.h"
#include "18_playground/editor_pointer.h"
#include "18_playground/editor_properties.h"
#include "18_playground/file_browser.h"

namespace lightwalk {

/// It places its panels, each of which owns its state, and gives them the keys: one member for each of them.
/// Large (21 functions, 12 members): it places panels: one member each.
struct EditorWindow : Playground, WindowTool {
    EditorWindow();
    bool on_mouse(const Input& input, glm::vec2 cursor_px, bool over_picture) override;
    bool on_key(const KeyPress& key) override;
    void on_drop(const std::vector<std::filesystem::path>& files) override;
    bool draw_panels(glm::uvec2 picture, float scale) override;
    float covered_px(glm::uvec2 picture, float scale) const override;
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
    void draw_toolbar();
    void draw_lights_toolbar();
    void draw_left_panel();
    void carry_on_previews();
    void scatter_lights();
    void frame_selected();

    EditorView view_{.chapter = *this, .automatic = nullptr, .press = {}};
    EditorFields fields_{view_};
    SceneFiles files_{view_};
    SettingsPanel settings_{view_, fields_, files_};
    TreePanel tree_{view_, settings_};
    PropertiesPanel properties_{view_, fields_, settings_, tree_};
    LoadingPanel loading_{view_};
    EditorPointer pointer_{view_};
    StepsPanel steps_{view_};
    KeysPanel keys_{view_};
    FileBrowser browser_;
    int scatter_count_ = 100;
};

}  // namespace lightwalk
