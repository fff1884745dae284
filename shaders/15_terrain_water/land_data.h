// The ground's height map on the device, as shaders and the processor see it.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const int CHUNK_LEVELS = 5;  // of the tree below a chunk: it has 2^CHUNK_LEVELS cells along a side
const int CHUNK_CELLS = 1 << CHUNK_LEVELS;

// Heights at samples x samples places; x runs eastwards (+x), y southwards (+z).
struct LandMap {
    vec2 corner;      // metres, world x and z of sample (0, 0)
    float spacing_m;  // from one sample to the next
    int samples;      // along a side: cells + 1
    int top;          // level of the one chunk that covers the map
    float highest_m;  // of the whole map, or more
};

// How the map is made of the source.
struct LandSource {
    vec2 first, step;  // source samples: of sample (0, 0), and from one to the next
    vec2 place_m;      // of sample (0, 0), from the source's middle
    float spacing_m;
    int samples;
    float datum_m, height_scale;
    float detail_m, cliffs, cliff_m;
    float edge_m;  // width of the coast around the map; 0: none
    vec4 plain;    // x and z in metres, radius, height; radius 0: none
};

// A square part of the ground, drawn with cells of 2^level samples.
struct Chunk {
    int x, z;  // in chunks of its level
    int level;
};

END_SHARED
