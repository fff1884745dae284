#include "18_playground/terrain_entry.h"

#include <fmt/core.h>

#include <algorithm>

namespace lightwalk {

EntryId terrain_of(const Document& document) {
    for (const EntryId id : with_children(document, root_entry))
        if (is_terrain(document.at(id))) return id;
    return no_entry;
}

void set_terrain(Document& document, const std::filesystem::path& file, float reach_m, uint64_t gesture) {
    const EntryId now = terrain_of(document);
    if (now == no_entry && file.empty()) return;
    document.begin("terrain", gesture);
    if (file.empty()) {
        document.remove({now});
    } else if (now != no_entry) {
        document.edit(now).object()->model = file;
    } else {
        SceneObject object;
        object.name = free_name(document, "ground");
        object.model = file;
        document.add(root_entry, {.what = std::move(object)});
    }
    if (!file.empty() && document.settings().camera.far_m < reach_m)
        document.edit(root_entry).settings()->camera.far_m = reach_m;
    document.commit();
}

float side_m(const HeightMap& map) {
    const glm::vec2 size_m = map.sample_m * glm::vec2(map.width - 1, map.height - 1);
    return std::min(size_m.x, size_m.y);
}

std::map<std::string, std::string> terrain_knobs(const HeightMap& map, const Bounds& scene) {
    const size_t middle = size_t(map.height / 2) * size_t(map.width) + size_t(map.width / 2);
    const float size_m = scene.empty() ? 1.0f : glm::length(scene.extent());
    const float floor_m = (scene.empty() ? 0.0f : scene.lower.y) - 0.002f * size_m;  // nothing flickers with it
    const float away_m = scene.empty() ? 0.0f : glm::length(glm::vec2(scene.center().x, scene.center().z)) + size_m;
    const float level_m = std::max(0.01f * side_m(map), 1.5f * away_m);
    return {{"air", "sky"},
            {"ground.datum_m", fmt::format("{:.0f}", map.elevation_m[middle] - floor_m)},
            {"ground.plain_km", fmt::format("0,0,{:.3f}", 1e-3f * level_m)},
            {"ground.plain_m", fmt::format("{:.4f}", floor_m)}};
}

}  // namespace lightwalk
