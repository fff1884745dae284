#include "15_terrain_water/land.h"

namespace lightwalk {

void Land::draw(Frame&, const View&, Canvas&) {}

}  // namespace lightwalk
