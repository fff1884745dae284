// Exercise 16.gradient: the direction in which the density grows.
// Starter: it does not grow, and surfaces are lit as if they faced nobody.
#include "16_volume/voxel_density.glsl"

// [gradient]
// Returns the gradient of the density at a point of the volume, per metre along each axis of
// the volume, by central differences: the density one voxel ahead minus the density one
// voxel back, divided by the distance between these two points.
//
// - voxel_density(at) is the density at a point; `at` is 0 to 1 along each axis.
// - `voxel` is the size of a voxel in that unit, one over the number of voxels per axis.
// - `voxel_m` is the size of a voxel in metres.
//
// Both sizes may differ from axis to axis: a scanner's voxels are often longer along one
// axis, and a volume may have more of them along one axis than along another. A gradient
// that ignores one of the two sizes points in a wrong direction.
// [/gradient]
vec3 gradient(vec3 at, vec3 voxel, vec3 voxel_m) {
    return vec3(0.0);
}
