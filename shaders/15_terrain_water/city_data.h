// A city's boxes, as shaders and the processor read them.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const uint CITY_HOUSE = 0u, CITY_TOWER = 1u, CITY_LAMP = 2u;

struct CityBox {
    vec2 place;      // metres, world x and z of its middle
    float yaw;       // radians about +y
    vec3 half_size;  // metres; y is half its height
    float base_m;    // of its foot over the ground
    uint kind;       // CITY_HOUSE, CITY_TOWER or CITY_LAMP
    uint number;     // seed of its colour and windows
};

// The blocks of a city as a grid over level ground, for rays. All boxes are turned by the same angle.
struct CityGrid {
    vec2 middle;    // metres, world x and z
    float yaw;      // radians about +y
    vec2 pitch;     // metres from one block to the next
    ivec2 most;     // blocks run from -most to most
    float highest;  // metres: of the highest box over its ground
};

END_SHARED
