// Where the terrain's grid lies at this moment.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct TerrainNow {
    ivec2 cell;   // the grid's middle in octave 0: a cell of it,
    vec2 offset;  // and where in the cell, 0 to 1
    vec3 eye;     // metres from the grid's middle; y is a height
    float pixel_rad;
    vec3 to_sun;      // unit length
    int cells;        // of a ring of the grid, along a side; a multiple of 4
    float spacing_m;  // of the innermost ring
    int rings;        // each twice as wide as the one within
};

END_SHARED
