// The editor's scene: entries with constant ids, and undoable steps.
#pragma once
#include <deque>
#include <memory>
#include <unordered_map>
#include <variant>

#include "18_playground/exercises.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

using EntryId = uint32_t;
inline constexpr EntryId no_entry = 0, root_entry = 1;

/// Scene-wide values of a scene file.
struct SceneSettings {
    Camera camera;
    glm::vec3 ambient{0.05f}, background{0.02f};
    Environment environment{};
    SceneMusic music{};
    std::map<std::string, std::string> knobs{};
    bool bare = false;  ///< as SceneFile has it
    float emission = 1;
};

// [entry]
/// A line of the tree. It is a value: a step keeps whole entries as they were before and after it.
struct Entry {
    EntryId parent = no_entry;
    std::vector<EntryId> children{};  ///< in order
    std::variant<SceneSettings, SceneObject, Light> what{};
    bool hidden = false;
    bool locked = false;    ///< neither picked nor changed
    bool included = false;  ///< from a file that the scene includes

    const SceneObject* object() const { return std::get_if<SceneObject>(&what); }
    const Light* light() const { return std::get_if<Light>(&what); }
    const SceneSettings* settings() const { return std::get_if<SceneSettings>(&what); }
    SceneObject* object() { return std::get_if<SceneObject>(&what); }
    Light* light() { return std::get_if<Light>(&what); }
    SceneSettings* settings() { return std::get_if<SceneSettings>(&what); }
    const std::string& name() const;
};
// [/entry]

/// It has a direction and no place.
inline bool is_sun(const Entry& entry) { return entry.light() && entry.light()->kind == Light::Kind::directional; }

/// Entries by id, the root among them, and the steps that led here. Changes are made between begin() and commit():
///
///     document.begin("move");
///     document.edit(id).object()->position.x += 1;
///     document.commit();
///
/// An id stands for one entry for as long as the document lives: an entry that was deleted and brought back by undo()
/// has the id it had.
class Document {
  public:
    Document();
    explicit Document(const SceneFile& scene);

    const Entry* find(EntryId id) const { return id < slots_.size() ? slots_[id].entry.get() : nullptr; }
    const Entry& at(EntryId id) const;
    size_t size() const { return count_; }  ///< entries, the root not among them
    const SceneSettings& settings() const { return *at(root_entry).settings(); }
    bool has_name(const std::string& name) const { return names_.contains(name); }  ///< of an object

    /// `group`: steps of one gesture have the same; 0: a step for itself.
    void begin(std::string name, uint64_t group = 0);
    Entry& edit(EntryId id);                           ///< all but its name
    void rename(EntryId id, const std::string& name);  ///< duplicate names are allowed
    /// Returns the new entry's id. `place`: among the parent's children; beyond the last one: at the end.
    EntryId add(EntryId parent, Entry entry, size_t place = SIZE_MAX);
    void remove(const std::vector<EntryId>& ids);  ///< with their children; none of them below another
    /// Side by side, in this order. `place`: among the children that the parent has without them.
    void move_below(const std::vector<EntryId>& ids, EntryId parent, size_t place = SIZE_MAX);
    void order_children(EntryId parent, std::vector<EntryId> order);  ///< the same ones
    bool commit();                                                    ///< false where nothing has changed
    void cancel();                                                    ///< everything as it was at begin()
    bool in_step() const { return open_.has_value(); }

    bool undo();
    bool redo();
    /// Undoes the last step where it is one of this gesture, and forgets it.
    bool take_back(uint64_t group);
    struct Listed {
        std::string name;
        uint64_t bytes;
        bool undone;
    };
    void forget_steps();                ///< none can be undone any more
    std::vector<Listed> steps() const;  ///< the oldest first
    size_t done() const { return done_.size(); }
    /// The name of the step that undo() or redo() would take; null: there is none.
    const std::string* next_undo() const { return done_.empty() ? nullptr : &done_.back().name; }
    const std::string* next_redo() const { return undone_.empty() ? nullptr : &undone_.back().name; }
    uint64_t bytes() const;  ///< that all steps hold

    /// Most that the steps hold.
    uint64_t most_bytes = uint64_t(100) << 20;

    /// Changes whenever an entry came, went, was moved in the tree or has another name; no two documents share one.
    uint64_t structure() const { return structure_; }

    /// Another number after each change, and the same one again where undo() and redo() come back to it.
    uint64_t state() const { return state_; }

    /// Children passed or moved so far while changing lists. Commands keep it proportional to their changes: removing
    /// 100,000 entries one by one from one list would pass 5,000,000,000.
    uint64_t children_passed() const { return children_passed_; }

    /// Entries touched since the last call, each once; whether some were added, removed or have another parent.
    struct Changes {
        std::vector<EntryId> entries;
        bool structure = false;
    };
    Changes take_changes();
    void mark_all_changed();  ///< for views that must restart

  private:
    struct Slot {
        std::shared_ptr<Entry> entry;
        bool touched = false;  ///< by the step that is being made
        bool listed = false;   ///< in changes_
    };
    struct Kept {
        EntryId id;
        std::shared_ptr<Entry> before, after;
    };
    struct Step {
        std::string name;
        UndoSize size;
        std::vector<Kept> kept;
        uint64_t state_before, state_after;
    };
    void put(EntryId id, std::shared_ptr<Entry> entry);
    Slot& touch(EntryId id);
    void note(EntryId id);
    void count_name(const Entry& entry, int by);
    void take_out(const std::vector<EntryId>& ids);
    void put_in(const std::vector<EntryId>& ids, EntryId parent, size_t place);
    Step joined(Step first, Step then) const;
    std::vector<Slot> slots_;
    std::unordered_map<std::string, int> names_;
    size_t count_ = 0;
    std::optional<Step> open_;
    std::deque<Step> done_;
    std::vector<Step> undone_;  ///< the last one undone is the last
    uint64_t state_ = 1, states_ = 1, structure_ = 0, children_passed_ = 0;
    void note_structure();
    Changes changes_;
};

/// Whether two entries are equal to the bit, except for fields filled by loading.
bool same_entry(const Entry& a, const Entry& b);

/// Everything of an object but its place and its material.
bool same_but_placed_and_painted(const SceneObject& a, const SceneObject& b);

/// Everything of an object but its place.
bool same_but_placed(const SceneObject& a, const SceneObject& b);

/// Approximate size of an entry, in bytes.
uint64_t bytes_of(const Entry& entry);

/// The entries below `id`, each before its children, in the tree's order; `id` itself is the first.
std::vector<EntryId> with_children(const Document& document, EntryId id);

}  // namespace lightwalk
