// The density that 16.gradient reads.
float voxel_density(vec3 at) { return stored_density(at); }
