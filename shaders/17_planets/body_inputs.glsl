// Inputs of every pass over a body.
#include "17_planets/body_data.h"

layout(scalar) uniform BodyBlock { BodyNow body; };
layout(scalar) uniform PlanetsBlock {
    int air_steps, walks, parallax_steps;
    float relief, height_m, clouds, night, waves;
} planets;
layout(scalar) uniform AtmosphereBlock { int paths; } atmosphere;
layout(scalar) uniform SeedBlock { uint seed; };

// Half the angle of the sun's disc for shadows of bodies: of a hard edge next to nothing.
float shadow_sun_rad() {
#if PLANETS_SHADOW == PLANETS_SHADOW_DISC
    return body.sun_rad;
#else
    return 1e-3 * body.sun_rad;
#endif
}

// How flat the body is that casts the shadow.
float shadow_flattening() {
#if PLANETS_SHADOW == PLANETS_SHADOW_SPHERE
    return 0.0;
#else
    return body.flattening;
#endif
}
