// What reflected rays meet, without shadows of houses.
#include "15_terrain_water/no_sun_shadow.glsl"
#include "15_terrain_water/reflected_rays.glsl"
