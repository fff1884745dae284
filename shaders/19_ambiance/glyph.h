// A letter of a title: its place in the line, and in the image of distances.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct Glyph {
    vec2 lower, upper;  // corners in the line, in heights of a capital, +y up
    vec2 first, end;    // texels of the upper left and lower right corner
};

// Half the range of distances that the image holds, in heights of a capital.
const float GLYPH_RANGE = 15.0f / 72.0f;  // Typeface draws 15 texels around letters of 72

END_SHARED
