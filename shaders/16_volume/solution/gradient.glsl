// Solution of 16.gradient.
#include "16_volume/voxel_density.glsl"

vec3 gradient(vec3 at, vec3 voxel, vec3 voxel_m) {
    vec3 ahead = vec3(voxel_density(at + vec3(voxel.x, 0.0, 0.0)), voxel_density(at + vec3(0.0, voxel.y, 0.0)),
                      voxel_density(at + vec3(0.0, 0.0, voxel.z)));
    vec3 back = vec3(voxel_density(at - vec3(voxel.x, 0.0, 0.0)), voxel_density(at - vec3(0.0, voxel.y, 0.0)),
                     voxel_density(at - vec3(0.0, 0.0, voxel.z)));
    return (ahead - back) / (2.0 * voxel_m);
}
