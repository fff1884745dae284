// How far light goes in skin: a sum of Gaussians, for red, green and blue.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

const uint SKIN_GAUSSIANS = 6u;

// [profile]
// E. d'Eon, D. Luebke and E. Enderton, "Efficient Rendering of Human Skin", EGSR 2007, section 5: the light that leaves
// skin r mm from where it entered, as a sum of Gaussians exp(-r² / 2v) / (2 pi v).
const float skin_variance_mm2[6] = {0.0064f, 0.0484f, 0.187f, 0.567f, 1.99f, 7.41f};
const vec3 skin_weight[6] = {vec3(0.233f, 0.455f, 0.649f), vec3(0.100f, 0.336f, 0.344f), vec3(0.118f, 0.198f, 0.0f),
                             vec3(0.113f, 0.007f, 0.007f), vec3(0.358f, 0.004f, 0.0f),   vec3(0.078f, 0.0f, 0.0f)};
// [/profile]

// A method's subset of them.
struct SkinSum {
    vec3 weight[6];
    uint count;
};

// One dispatch of a blur.
struct SkinBlur {
    ivec2 direction;  // (1, 0) along u, (0, 1) along v
    vec3 sigma_mm;    // of this blur, for each channel
    float smooth_mm;  // sigma of the input: it has no finer detail, so texels can be skipped
};

#ifndef __cplusplus
// Of the preintegrated table: its curvature, in 1/mm, over v from 0 to 1. The finest detail is a sphere of 1 mm.
float curvature_at(float v) { return v * v; }
float curvature_v(float curvature_per_mm) { return sqrt(clamp(curvature_per_mm, 0.0, 1.0)); }
#endif

END_SHARED
