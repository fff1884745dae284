// What a scene and a view need: how many of the lights reach a pixel, and what each way of culling would therefore
// cost.
#pragma once
#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace lightwalk {

/// A method and, where the falloff never ends, the radiance at which culling takes it to have ended.
struct CullingChoice {
    std::string method;
    float threshold = 0;  ///< 0: the falloff ends by itself, or nothing is culled
    double error = 0;     ///< predicted mean FLIP error against every light
    double cost = 0;      ///< predicted: lights computed for pixels and the like, in millions
};

struct CullingNeed {
    size_t lights = 0;
    double lights_per_pixel = 0;  ///< that reach what is seen there, mean over the pixels that are not background
    std::vector<CullingChoice> choices;  ///< every one, cheapest first
};

/// Measures the scene as `camera` sees it at `size` pixels. `slices` is of clusters. `endless`: the falloff is an
/// inverse square that never ends; otherwise each light ends at its range.
CullingNeed measure_culling(const Scene& scene, const Camera& camera, glm::uvec2 size, const std::vector<Light>& lights,
                            int slices, bool endless);

/// The cheapest choice within the budget; computing every light has no error, so that there is always one.
const CullingChoice& cheapest_within(const CullingNeed& need, double budget);

/// What was measured, the rule and the choice, a line each.
std::vector<std::string> explain(const CullingNeed& need, const CullingChoice& choice, double budget);

}  // namespace lightwalk
