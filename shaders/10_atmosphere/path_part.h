// One dispatch's share of each path's light, for paths too long for one dispatch.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct PathPart {
    int first_walk, end_walk;    // of the random paths; none where both are the same
    int first_place, end_place;  // of the places for light scattered once
    int begins, ends;            // whether there is nothing before it, and nothing after
};

END_SHARED
