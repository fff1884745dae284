// Exercise 16.skip_empty: the smallest and the largest density of a block of voxels, found by 64 threads together.
// Starter: each block takes the range of its first voxel, and most of the volume is skipped.
#include "16_volume/block_voxels.glsl"

// [skip_empty]
// Finds the smallest and the largest density that a trilinear sample within a block can read,
// and stores (smallest, largest, 0, 0) with imageStore(ranges, block, ...).
//
// - The block has BLOCK_VOXELS voxels along each edge and begins at the voxel
//   block * BLOCK_VOXELS.
// - A sample near the face of the block also reads voxels of the next block. Include the
//   voxels up to `border` (1 or more) beyond each face, edges and corners too.
// - texelFetch(voxels, at, 0).r is the density of a voxel. Outside the volume the outermost
//   voxel is repeated: clamp `at` to the range 0 to textureSize(voxels, 0) - 1.
// - A density that is NaN counts as 0.
//
// A workgroup of 64 threads calls the function for one block; gl_LocalInvocationIndex is 0
// to 63. Each thread examines its share of the voxels and writes its (smallest, largest) to
// thread_ranges[gl_LocalInvocationIndex], a shared array of vec2. The 64 ranges are then
// reduced to one by halving their number six times, with a barrier() before each halving,
// and thread 0 stores the result. Every thread must reach every barrier().
// memoryBarrierShared() does not wait for other threads.
// [/skip_empty]
void skip_empty(ivec3 block) {
    if (gl_LocalInvocationIndex == 0u) {
        float density = texelFetch(voxels, block * BLOCK_VOXELS, 0).r;
        imageStore(ranges, block, vec4(density, density, 0.0, 0.0));
    }
}
