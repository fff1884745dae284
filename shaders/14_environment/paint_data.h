// The layered model from which car paint is tabulated.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const int PAINT_TEXELS = 64;  // along n·l and along n·v

END_SHARED
