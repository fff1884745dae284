// Solution of 15.chunk_level.
#include "15_terrain_water/chunk_list.glsl"

bool is_split(Chunk chunk) {
    return chunk.level > 0 && chunk_error(chunk) > chunk_distance(chunk) * chunk_limit();
}

void chunk_level(Chunk chunk) {
    if (is_split(chunk)) return;
    if (chunk.level < top_level() && !is_split(Chunk(chunk.x / 2, chunk.z / 2, chunk.level + 1))) return;
    if (!chunk_in_view(chunk)) return;
    chunk_list[atomicAdd(chunk_draw.instance_count, 1u)] = chunk;
}
