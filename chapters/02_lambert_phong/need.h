// What a scene and a view need: how wide highlights are on the screen against triangles and pixels, and what each
// method would therefore get wrong.
#pragma once
#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace lightwalk {

/// What FLIP would say of a large area of one colour in the place of another, about: 0.03 for each 8-bit step of grey, to
/// the power that FLIP's colour term has. Linear colours.
double flip_of(glm::dvec3 a, glm::dvec3 b);

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

/// The cheapest choice within the budget; the most accurate one where none is.
const ShadingChoice& cheapest_within(const ShadingNeed& need, double budget);

/// What was measured, the rule and the choice, a line each.
std::vector<std::string> explain(const ShadingNeed& need, const ShadingChoice& choice, double budget);

}  // namespace lightwalk
