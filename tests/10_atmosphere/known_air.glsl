// For checks: the air that they say.
#include "10_atmosphere/air_data.h"

const Air check_known_air = CHECK_KNOWN_AIR;
#define air check_known_air
