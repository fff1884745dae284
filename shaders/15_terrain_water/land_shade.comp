// What the ground looks like where it was found, without shadows of houses.
#include "15_terrain_water/no_sun_shadow.glsl"
#include "15_terrain_water/land_shade.glsl"
