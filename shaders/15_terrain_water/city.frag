// A box of a city, without shadows of houses.
#include "15_terrain_water/no_sun_shadow.glsl"
#include "15_terrain_water/city_surface.glsl"
