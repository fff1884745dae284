// Commands on the document: each function is a step that undo() reverts.
#pragma once
#include <set>
#include <string>

#include "15_terrain_water/height_map.h"
#include "18_playground/placement.h"
#include "common/scene/mesh.h"

namespace lightwalk {

/// An object that a module draws as ground: it has no place of its own.
inline bool is_terrain(const Entry& entry) { return entry.object() && is_height_map_file(entry.object()->model); }

/// The first one; no_entry: the scene has none.
EntryId terrain_of(const Document& document);

/// Another height map, or a first one; an empty `file`: none. The camera then sees as far as `reach_m`.
void set_terrain(Document& document, const std::filesystem::path& file, float reach_m, uint64_t gesture);

/// Side of the map, in metres, unless a knob says another.
float side_m(const HeightMap& map);

/// Knobs, by path, for a sky over it, and for ground that is level around the scene and just below it.
std::map<std::string, std::string> terrain_knobs(const HeightMap& map, const Bounds& scene);

/// Bytes that the character at the beginning of `text` takes in UTF-8; 0 where it is none: cut off, overlong, a
/// surrogate, beyond U+10FFFF.
size_t utf8_length(std::string_view text);

/// Entries that are selected, in the order in which they were clicked; the last is the active one.
struct Selection {
    std::vector<EntryId> ids;
    bool has(EntryId id) const { return members_.contains(id); }
    void set(std::vector<EntryId> chosen);
    void toggle(EntryId id);
    void clear() { set({}); }
    EntryId active() const { return ids.empty() ? no_entry : ids.back(); }
    void drop_missing(const Document& document);  ///< after undo(): ids that no longer exist

  private:
    std::set<EntryId> members_;
};

/// A command's message to the person; empty on success.
using Said = std::string;

/// Text as UTF-8: every byte that is not part of it becomes U+FFFD; control characters, a space.
std::string clean_name(const std::string& name);

/// For each name without its number, the number to go on with: names of many copies are then found without trying all
/// that are taken for each of them.
using NextNumbers = std::unordered_map<std::string, int>;

/// The name, or with a number behind it where another object has it.
/// `own`: the name that it has now, which is no other's.
std::string free_name(const Document& document, const std::string& name, const std::string& own = "",
                      NextNumbers* numbers = nullptr);

/// Whether it, or an entry above it, is locked.
bool is_locked(const Document& document, EntryId id);
bool is_hidden(const Document& document, EntryId id);

/// The existing, unlocked ones of `ids` without a selected ancestor, in tree order.
std::vector<EntryId> movable(const Document& document, const std::vector<EntryId>& ids);

EntryId add_object(Document& document, SceneObject object, EntryId parent = root_entry);
EntryId add_light(Document& document, const Light& light);
std::vector<EntryId> add_lights(Document& document, const std::string& step, const std::vector<Light>& lights);
/// Point and spot lights over `where`, as chapter 03 scatters them.
std::vector<EntryId> scatter(Document& document, const Bounds& where, int count, unsigned seed);
Said remove(Document& document, const std::vector<EntryId>& ids);
std::vector<EntryId> duplicate(Document& document, const std::vector<EntryId>& ids);
/// A new parent for the objects among them, below their common parent, or else below the scene. Its pivot is the
/// middle of `around`, their bounds in the world; if empty, of their positions. no_entry: none is an object.
EntryId group(Document& document, const std::vector<EntryId>& ids, const std::string& name, const Bounds& around = {});
/// Their places in the world stay. Refuses cycles, parents that are no object, and lights.
Said reparent(Document& document, const std::vector<EntryId>& ids, EntryId parent, size_t place = SIZE_MAX);
Said rename(Document& document, EntryId id, const std::string& name);
void set_hidden(Document& document, const std::vector<EntryId>& ids, bool hidden);
void set_locked(Document& document, const std::vector<EntryId>& ids, bool locked);
/// Why the scene file would refuse this placement: a zero scale, or values that are not finite or too large.
Said cannot_be_placed(const Placement& placement);
/// Refuses an invalid placement.
Said place(Document& document, EntryId id, const Placement& placement, uint64_t gesture = 0);
/// Knobs of the chapter that have another value than the document says.
void set_knobs(Document& document, const std::map<std::string, std::string>& knobs, uint64_t gesture);

}  // namespace lightwalk
