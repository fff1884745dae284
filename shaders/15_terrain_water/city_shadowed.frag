// A box of a city, with the shadows of houses.
#include "15_terrain_water/sun_shadow.glsl"
#include "15_terrain_water/city_surface.glsl"
