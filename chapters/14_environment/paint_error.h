// Error of car paint over directions.
#pragma once
#include "14_environment/paint.h"

namespace lightwalk {

/// paint_brdf() of 14_environment/paint_brdf.glsl for n·l, n·v and l·v. Records the paint if it must be. Blocks.
std::vector<glm::vec3> looked_up(Gpu& gpu, CarPaint& paint, const std::vector<glm::vec3>& cosines);

/// Root mean square difference between looked_up() and random walks of the default WalkedPaint, over that of the walks:
/// 1,024 pairs of directions, each as dense as its cosine. Blocks.
double direction_error(Gpu& gpu, CarPaint& paint);

}  // namespace lightwalk
