// For the check of 16.gradient: densities that are known.
#pragma replaces "16_volume/voxel_density.glsl"
float voxel_density(vec3 at) { return KNOWN_DENSITY; }
