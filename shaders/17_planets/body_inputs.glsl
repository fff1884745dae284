// What every pass over a body is given.
#include "17_planets/body_data.h"

layout(scalar) uniform BodyBlock { BodyNow body; };
layout(scalar) uniform PlanetsBlock {
    int air_steps;
    float relief, clouds, night, waves;
} planets;
