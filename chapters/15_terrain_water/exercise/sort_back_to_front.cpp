// Exercise 15.sort_back_to_front: the order in which transparent surfaces are drawn.
// Starter: they are drawn in the order of the scene file, and panes that lie behind cover those in front.
#include <numeric>

#include "15_terrain_water/exercises.h"

namespace lightwalk::exercise {

// [sort_back_to_front]
// `middles` holds the middle of each transparent surface, `eye` the camera's position; both
// in metres, world space, and finite. Returns the numbers 0 to middles.size() - 1, each once:
// the surface that is farthest from the eye comes first, the nearest last.
//
// "Far" is the distance from the eye in any direction, not the depth along the view: when the
// camera turns where it stands, the order must not change, or panes pop. Surfaces that are
// equally far keep the order in which they came, so that it does not change from frame to frame
// either. Of two whose distances differ by less than a millionth of the distance either may come
// first. Up to 10,000 surfaces are sorted in each frame: an algorithm whose comparisons grow with
// the square of their number is too slow.
// [/sort_back_to_front]
std::vector<uint32_t> sort_back_to_front(const std::vector<glm::vec3>& middles, glm::vec3 eye) {
    (void)eye;
    std::vector<uint32_t> order(middles.size());
    std::iota(order.begin(), order.end(), 0u);
    return order;
}

}  // namespace lightwalk::exercise
