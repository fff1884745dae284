// The list of chunks that are drawn, and the command that draws them.
#include "15_terrain_water/chunks.glsl"

layout(scalar) buffer ChunkListBlock { Chunk chunk_list[]; };
layout(scalar) buffer ChunkDrawBlock {
    uint index_count;     // of one chunk's triangles
    uint instance_count;  // how many chunks are drawn: 0 when the dispatch begins
    uint first_index;
    int vertex_offset;
    uint first_instance;
} chunk_draw;
