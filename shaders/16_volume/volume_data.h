// Parameters of a volume's passes beside its knobs.
#pragma once
#include <common/shared.h>

#include "common/view_rays.h"

BEGIN_SHARED

const int TRANSFER_TEXELS = 256;          // of the transfer function, over densities from 0 to 1
const float REFERENCE_M = 0.01f;          // metres: the length for which the transfer function states its opacities
const float LEAST_TRANSMITTANCE = 1e-3f;  // of REFERENCE_M metres, where light is scattered
const int BLOCK_VOXELS = 8;               // along an edge of the blocks of density ranges
const int BLOCK_LEVELS = 3;               // of the pyramid over them: blocks, then 2, then 4 of them along an edge

// A moment of noise over space and time: whole cells of time and the rest, which the processor parts in double precision.
struct NoiseMoment {
    int cell;       // of time
    float time;     // within it, 0 to 1
    int skew_cell;  // simplex noise skews its axes by (sqrt(5) - 1) / 4 of their sum: of the time's share of that, the
    float skew_time;  // whole cells and the rest
    int seed;
};

struct VolumeNow {
    ViewRays rays;
    vec3 half_m;         // half the edges of its box, metres; the box's centre is the world's origin
    float radius_m;      // of the ball that bounds it; 0: its box does
    mat3 to_volume;      // from the world's axes to the volume's
    vec3 size;           // voxels along each of the volume's axes
    float step_m;        // from sample to sample, metres
    vec3 light_at;       // where its light stands, metres; or, for light from far away, the unit vector towards it
    float is_near;       // 1: the light stands at light_at; 0: it is far away
    vec3 light;          // irradiance at 1 m, or of a distant light, without the volume
    float brightest;     // radiance that no sample exceeds, for the early exit
    float majorant;      // extinction that no density exceeds, 1/m, for random walks
    vec3 wave_phase;     // radians, 0 to 2 pi: of the three waves
    float wave;          // amplitude of each wave, in units of the box; 0: none
    NoiseMoment moment;  // of the shell's noise
    float history;       // pictures in the history
    float turn;          // of the samples within a step, 0 to 1, from picture to picture
    uint seed;           // of the random walks
};

END_SHARED
