// Exercise 16.gradient: which way the density grows.
// As it stands it does not grow, and surfaces are lit as if they faced nobody.
#include "16_volume/voxel_density.glsl"

// [gradient]
// The gradient of the density at a place of the volume, per metre along the volume's axes. voxel_density(at) is the density
// at a place from 0 to 1 along each axis; `voxel` is the size of a voxel in that unit, one over the number of voxels along
// each axis, and `voxel_m` its size in metres. By central differences: along each axis the densities one voxel before and
// one voxel behind `at`. A scanner's voxels are often longer along one axis, and a volume has more of them along one axis
// than along another: a gradient that forgets either is turned.
// [/gradient]
vec3 gradient(vec3 at, vec3 voxel, vec3 voxel_m) {
    return vec3(0.0);
}
