// What a scene and a view need: how wide highlights are on the screen against triangles and pixels, and what each
// method would therefore get wrong.
#pragma once
#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace lightwalk {

/// A way to shade: a method and, per pixel, how many samples along each side.
struct ShadingChoice {
    std::string method;
    int samples = 1;
    double error = 0;  ///< predicted mean FLIP error against the supersampled normalised model
    double cost = 0;   ///< predicted evaluations of the model, in millions
};

struct ShadingNeed {
    double highlight_px = 0;             ///< width of highlights on the screen, median over what is seen
    double triangle_px = 0;              ///< side of triangles on the screen, median over what is seen
    std::vector<ShadingChoice> choices;  ///< every one, cheapest first
};

/// Measures a scene as `camera` sees it at `size` pixels. `view_projection` is the camera's matrix; `shininess` above 0
/// stands for every material's own. Textures and occlusion are left out: what they hide needs no less than it says.
ShadingNeed measure_need(const Scene& scene, const glm::mat4& view_projection, glm::vec3 eye, glm::uvec2 size,
                         float shininess);

/// The FLIP error, 0 to 1, that somebody may see between two colours in linear light: from the difference of their sRGB
/// codes alone.
double expected_flip(glm::dvec3 shown, glm::dvec3 truth);

/// The cheapest choice within the budget; the most accurate one where none is.
const ShadingChoice& cheapest_within(const ShadingNeed& need, double budget);

/// What was measured, the rule and the choice, a line each.
std::vector<std::string> explain(const ShadingNeed& need, const ShadingChoice& choice, double budget);

}  // namespace lightwalk
