// Chapter 10's air for tests, after the bodies: what it calls earth is a radius, no body.
#pragma once
#include "../10_atmosphere/known_air.h"
