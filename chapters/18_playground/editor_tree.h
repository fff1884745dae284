// The tree of the scene's entries.
#pragma once
#include "18_playground/editor_settings.h"

namespace lightwalk {

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

}  // namespace lightwalk
