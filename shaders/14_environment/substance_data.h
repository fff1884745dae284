// Surface properties of a model's material beyond chapter 04's numbers, for each of the scene's items.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

struct SubstanceData {
    float alpha;      // GGX, the square of roughness; below 0: chapter 04's numbers say it
    float metalness;  // 0 to 1: how much of the colour is not diffuse, where chapter 04's numbers do not say so already
    uint paint;       // 1: car paint
    uint glass;       // 1: reflections cover all of a transparent surface; else alpha is the share that is covered
    float bumps_per_m;  // of a surface without texture coordinates
    float bump_depth;   // as a share of a bump's width; 0: smooth
};

END_SHARED
