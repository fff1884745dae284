// Terrain of an edited scene: the entry of its height map, and where its ground lies.
#pragma once
#include "15_terrain_water/height_map.h"
#include "18_playground/commands.h"
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

}  // namespace lightwalk
