// Scene-wide entries: camera, surroundings, terrain, water, fog and effects.
#pragma once
#include "18_playground/editor_fields.h"
#include "18_playground/editor_files.h"

namespace lightwalk {

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

}  // namespace lightwalk
