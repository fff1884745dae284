// Sunlight at a point in the air: each pass includes one of sun_marched.glsl, sun_closed.glsl and sun_table.glsl.
#include "10_atmosphere/air.glsl"

// 0 to 1, by channel; 0 in the planet's shadow.
vec3 sun_transmittance(Place place);

// Radiance that comes from all sides alike, having been scattered before; nothing where no table knows it.
vec3 scattered_before(Place place);
