// The editor without its window: a document, a selection, and their connection to a chapter and its scene.
#pragma once
#include "18_playground/gizmo.h"
#include "18_playground/live_scene.h"
#include "18_playground/tree.h"
#include "common/app/chapter.h"

namespace lightwalk {

/// As a scene file names it: relative to the course's assets, as any clone finds it, or whole.
std::filesystem::path asset_name(const std::filesystem::path& file);

class Editor {
  public:
    Document document;
    SceneStore store;
    Selection selection;
    Tree tree;
    LiveScene live;
    Tool tool = Tool::move;
    bool local = false;
    float scale = 1.0f;  ///< of the gizmo and other marks: as the window's panels
    std::optional<GizmoDrag> drag;
    Handle hot;            ///< under the mouse
    uint64_t gesture = 1;  ///< another one for each press of a button or key
    std::string notice;    ///< message to the person; empty: none

    /// A scene was loaded: a new document. Where a scene was loaded again, and the document has changes that are not
    /// saved or is that of another file, it stays, and update() brings it into the scene.
    void loaded(Chapter& chapter);

    /// Opens the document's scene in the chapter. Throws InputError, with nothing changed. `give`: fills the new
    /// scene's pools with loaded resources.
    void open(Chapter& chapter, Gpu& gpu, const std::filesystem::path& file,
              const std::function<void(Scene&)>& give = {});
    void open_document(Chapter& chapter, Document next);
    /// Restores this scene's state from a crash. If it cannot be shown, update() reverts to the previous state and
    /// keeps the file under another name.
    void recover(Chapter& chapter);

    /// Between frames: turns knob changes in the panel into steps, and shows the document's changes. Changes that
    /// cannot be shown are undone, and `notice` says why; if an earlier step's file is no longer readable, nothing is
    /// undone and the picture omits it.
    bool update(Chapter& chapter, Gpu& gpu);
    bool loads = false;  ///< of the last update(): modules have something to prepare

    bool undo(Chapter& chapter);
    bool redo(Chapter& chapter);
    /// Undoes or does again until so many steps are done; the knobs and `notice` follow once.
    void go_to(Chapter& chapter, size_t done);
    void save(const Chapter& chapter, const std::filesystem::path& as = {});

    void begin_drag(const GizmoPlace& place, const Handle& handle, const View& view, glm::vec2 cursor_px);
    void end_drag(bool keep);
    /// Another step, a key's for example, has closed the drag's own: it ends where it was then.
    void drop_drag_of_closed_step() {
        if (drag && !document.in_step()) drag.reset();
    }

    /// An item of the scene, from picking. `add`: toggles it in the selection.
    void select_item(const Scene& scene, std::optional<uint32_t> item, bool add);
    std::optional<EntryId> light_at(const View& view, glm::vec2 cursor_px) const;
    std::vector<uint32_t> selected_items(const Scene& scene) const;  ///< 1 and on, or 0 if it is not
    Bounds selected_bounds(const Scene& scene) const;                ///< empty where nothing is selected
    void remove_selected();
    void group_selected(const Scene& scene);  ///< about the middle of their drawn bounds

    EntryId add_model(const std::filesystem::path& model, const Placement& placement);
    EntryId add_light(const Light& light);
    /// Cameras and lights of an object's model file, in the world.
    struct Offered {
        std::vector<std::pair<std::string, Camera>> cameras;  ///< by name
        std::vector<Light> lights;
    };
    Offered offered(const Scene& scene, EntryId object) const;
    void export_to(const Scene& scene, const std::filesystem::path& file);

  private:
    std::vector<uint32_t> items_of(const Scene& scene, const std::vector<EntryId>& ids) const;
    void take_knobs(const Chapter& chapter);
    void give_knobs(Chapter& chapter);
    void follow_steps(Chapter& chapter, std::string what);
    std::map<std::string, std::string> first_knobs_, known_knobs_;
    void keep_recovery(const std::string& why);
    bool show_without(Chapter& chapter, Gpu& gpu, const std::string& why);
    std::vector<std::string> without_;           ///< why the picture has not all of the document; said once
    VkBuffer shown_instances_ = VK_NULL_HANDLE;  ///< of the scene that is shown: another one has others
    const Scene* shown_ = nullptr;
    std::optional<std::pair<Document, SceneStore>> recovered_from_;  ///< until the recovered scene has been shown
    std::filesystem::path first_file_;                               ///< of the scene that the chapter's host loads
};

}  // namespace lightwalk
