// The selection as numbers, colours and files.
#pragma once
#include "18_playground/editor_ball.h"
#include "18_playground/editor_settings.h"
#include "18_playground/editor_tree.h"
#include "18_playground/properties.h"

namespace lightwalk {

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
    void draw_light(EntryId id);
    /// A field of a property of together_: an edit applies to all of them.
    void edit(const Property& property, const std::function<bool(glm::vec3& value, glm::bvec3 mixed)>& field);
    void edit_number(const Property& property, const char* label, const char* help, float speed, float lower,
                     float upper);
    void edit_numbers(const Property& property, const char* label, const char* help, float speed);
    void edit_color(const Property& property, const char* label, const char* help, float most);
    void edit_map(const std::string& slot);
    EditorFields& fields_;
    SettingsPanel& settings_;
    TreePanel& tree_;
    std::vector<EntryId> together_;  ///< entries being edited; the active one is the last
};

}  // namespace lightwalk
