// For checks: the air that they say.
#include "10_atmosphere/air_data.h"

const Air known_air = KNOWN_AIR;
#define air known_air
