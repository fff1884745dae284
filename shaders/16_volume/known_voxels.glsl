// The densities that 16.gradient reads: the volume's, or for a check known ones.
#ifdef KNOWN_DENSITY
float voxel_density(vec3 at) { return KNOWN_DENSITY; }
#else
float voxel_density(vec3 at) { return stored_density(at); }
#endif
