// What reflected rays meet, with the shadows of houses.
#include "15_terrain_water/sun_shadow.glsl"
#include "15_terrain_water/reflected_rays.glsl"
