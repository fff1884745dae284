// Shader data of a water surface.
#pragma once
#include <common/shared.h>

BEGIN_SHARED

// One wave as gerstner() takes it.
struct WaveData {
    vec2 k;           // 1/m
    float amplitude;  // metres
    float steepness;
    float phase;  // radians, 0 to 2 pi
};

struct WaterNow {
    vec2 center;               // x and z below the camera: the middle of the rings
    float level_m;             // of the water at rest
    float first_m, growth;     // radius of the first ring, and growth factor per ring
    float from_rad, wide_rad;  // the sector that is seen
    float pixel_rad;           // of the view
    vec3 absorption;           // 1/m
    vec3 turbid;               // diffuse albedo of deep water
    vec3 to_sun, sun, sky;     // as Scene::sun() has it
    float roughness;           // standard deviation of the slopes of ripples that no wave stands for
    float refraction;          // 0: straight through
    float shore_m;             // depth up to which there is foam
    float foam;                // value of the Jacobian below which there is foam
    float foam_scale;          // 1/m
    float inverse_near, inverse_far;
    float eye_depth_m;  // how far the eye is below the surface; below 0: above it
    vec3 tile_m;        // of the cascades of the spectrum
    vec3 cut_m;         // wavelength that stands for each, between its longest and its shortest
    vec3 hidden;        // variance of the slopes of each
    float chop;         // scale factor of the horizontal displacement
    uint waves;
    uint mirrored;  // 1: there is a mirror image
    WaveData wave[16];
};

// How the slopes of a part of the ocean have travelled: sums over its waves.
struct OceanTravel {
    vec3 squares;   // of slope² k kᵀ: xx, xz, zz; 1/m²
    vec2 turned;    // of slope² turn k, the turn of a phase in radians; 1/m
    float changed;  // of slope² turn²
};

// The water of the frame before.
struct WaterBefore {
    float level_m;
    uint waves;
    vec3 ring_phase;  // radians
    OceanTravel ocean[3];
    WaveData wave[16];
};

const uint RINGS = 288u, SPOKES = 256u;

const uint OCEAN_TEXELS = 256u, OCEAN_LEVELS = 8u;

// One wave of the ocean's spectrum.
struct OceanWave {
    vec2 forward;   // complex amplitude in metres of the wave along k
    vec2 backward;  // of the wave against it, conjugated
    vec2 k;         // 1/m
    float cycles;   // in the time after which all repeats: an integer
};

struct OceanNow {
    float passed;  // of the time after which all repeats, 0 to 1
    float chop;    // scale factor of the horizontal displacement
};

END_SHARED
