// Exercise 15.chunk_level: which chunks of the ground are drawn. Runs in a dispatch with a thread for each chunk of each level.
// Until you fill it in, the one chunk that covers the whole map is drawn.
#include "15_terrain_water/chunk_list.glsl"

// [chunk_level]
// Decides about one chunk, and appends it to chunk_list if it is to be drawn.
//
// Level 0 is the finest. A chunk of level n covers four of level n - 1: (2x, 2z), (2x + 1, 2z), (2x, 2z + 1) and
// (2x + 1, 2z + 1). The one of level top_level() covers the map. A chunk is *split* where its level is above 0 and
// chunk_error(chunk) is greater than chunk_distance(chunk) * chunk_limit(): then its four are asked instead. Drawn
// are those that are not split themselves, whose parent is (the chunk at the top has none), and that chunk_in_view(). So
// every place of the map is drawn exactly once, or not in view. A split chunk's parent is split, too: nobody need look
// farther up.
//
// To append: atomicAdd(chunk_draw.instance_count, 1u) returns the number before, which is this chunk's place in chunk_list
// alone. Other threads append at the same time: reading the count and writing it back are not one step.
// [/chunk_level]
void chunk_level(Chunk chunk) {
    if (chunk.level == top_level()) chunk_list[atomicAdd(chunk_draw.instance_count, 1u)] = chunk;
}
