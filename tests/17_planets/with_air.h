// Chapter 10's air for tests, after the bodies: its name earth is a radius, not a body.
#pragma once
#include "../10_atmosphere/known_air.h"
