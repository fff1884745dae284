// What the ground looks like where it was found, with the shadows of houses.
#include "15_terrain_water/sun_shadow.glsl"
#include "15_terrain_water/land_shade.glsl"
