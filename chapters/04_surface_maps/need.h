// What a scene and a view need of a height map: how far it moves things on the screen, and what each method would
// therefore get wrong.
#pragma once
#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace lightwalk {

/// A way to see a height map.
struct ParallaxChoice {
    std::string method;
    int steps = 1;
    double error = 0;  ///< predicted mean FLIP error against the exact hits
    double cost = 0;   ///< predicted texture reads, in millions
};

struct ParallaxNeed {
    double parallax_px = 0;               ///< by which depth 1 moves things on the screen, median over what is seen
    double texels = 0;                    ///< that a ray crosses on its way to depth 1, median over what is seen
    std::vector<ParallaxChoice> choices;  ///< every one, cheapest first
};

/// Measures a scene as `camera` sees it at `size` pixels, with height maps `height_m` deep. A few thousand rays look
/// for the nearest triangle; where it has a height map, every method is tried on the CPU, and shaded with the
/// directional lights.
ParallaxNeed measure_need(Gpu& gpu, const Scene& scene, const Camera& camera, glm::uvec2 size, double height_m);

/// The cheapest choice within the budget; the most accurate one where none is.
const ParallaxChoice& cheapest_within(const ParallaxNeed& need, double budget);

/// What was measured, the rule and the choice, a line each.
std::vector<std::string> explain(const ParallaxNeed& need, const ParallaxChoice& choice, double budget);

}  // namespace lightwalk
