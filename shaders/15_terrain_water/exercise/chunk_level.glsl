// Exercise 15.chunk_level: which chunks of the ground are drawn. Runs in a dispatch with a thread for each chunk of each level.
// Starter: the one chunk that covers the whole map is drawn.
#include "15_terrain_water/chunk_list.glsl"

// [chunk_level]
// Decides about one chunk of the ground, and appends it to chunk_list if it is to be drawn.
//
// A Chunk has the integers x, z and level. Level 0 is the finest. The chunk (x, z) of level n
// covers four chunks of level n - 1: (2x, 2z), (2x + 1, 2z), (2x, 2z + 1) and
// (2x + 1, 2z + 1). The only chunk of level top_level() covers the whole map.
//
// A chunk is *split* if its level is above 0 and chunk_error(chunk) is greater than
// chunk_distance(chunk) * chunk_limit(): its four chunks are then considered instead. A
// chunk is drawn if
// - it is not split itself,
// - its parent is split (the chunk of level top_level() has no parent), and
// - chunk_in_view(chunk) is true.
//
// Every point of the map is then drawn exactly once, or is out of view. The parent of a split
// chunk is always split, too, so there is no need to look further up.
//
// atomicAdd(chunk_draw.instance_count, 1u) returns the number of chunks before this one,
// which is the index of this chunk in chunk_list. Reading the count and writing it back in two
// steps would let another thread in between.
// [/chunk_level]
void chunk_level(Chunk chunk) {
    if (chunk.level == top_level()) chunk_list[atomicAdd(chunk_draw.instance_count, 1u)] = chunk;
}
