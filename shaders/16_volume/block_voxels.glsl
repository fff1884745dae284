// Interface of exercise 16.skip_empty.
#include "16_volume/volume_data.h"

// 64 threads for one block of BLOCK_VOXELS voxels along each edge.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

uniform sampler3D voxels;
layout(rg16f) writeonly uniform image3D ranges;
layout(scalar) uniform BorderBlock { int border; };  // voxels that a sample of the block may reach beyond it

shared vec2 thread_ranges[64];  // (least, greatest): one for each thread
