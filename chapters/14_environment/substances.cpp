#include "14_environment/substances.h"

#include <algorithm>

#include "14_environment/substance_data.h"

namespace lightwalk {

void Substances::prepare(Gpu& gpu, Scene& scene) {
    std::vector<SubstanceData> substances;
    for (const DrawItem& item : scene.items) {
        const bool in_scene = item.roughness >= 0 || item.metalness >= 0 || item.maps[MapSlot::orm];
        const float rough = item.material.roughness;
        // A material that says nothing has the default; then its exponent says how rough it is.
        const bool in_model = !in_scene && rough != Material{}.roughness;
        substances.push_back({in_model ? std::max(rough * rough, 1e-3f) : -1.0f,
                              in_scene ? 0.0f : item.material.metalness, item.material.name == "paint" ? 1u : 0u});
    }
    if (substances.empty()) substances.emplace_back();
    substances_ = gpu.upload("substances", substances);
}

}  // namespace lightwalk
