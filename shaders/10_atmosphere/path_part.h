// What one dispatch finds of the light of each path, where one alone would take too long.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct PathPart {
    int first_walk, end_walk;    // of the random paths; none where both are the same
    int first_place, end_place;  // of the places for light scattered once
    int begins, ends;            // whether there is nothing before it, and nothing after
};

END_SHARED
