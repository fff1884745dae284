// Exercise 16.skip_empty: the least and the greatest density of a block of voxels, found by 64 threads together.
// As it stands each block takes the range of its first voxel, and most of the volume is skipped.
#include "16_volume/block_voxels.glsl"

// [skip_empty]
// Writes to `ranges` at `block` the (least, greatest, 0, 0) of the densities that a trilinear sample within the block may
// read. The block holds the voxels from block * BLOCK_VOXELS on, BLOCK_VOXELS along each edge; a sample at its face mixes
// them with the voxels of the next block: with those up to `border` voxels (1 or more) beyond each face. Voxels outside of
// the volume are those at its border, once more: clamp the coordinate to textureSize(voxels, 0) - 1. A voxel is
// texelFetch(voxels, at, 0).r; one that is NaN counts as 0.
//
// All 64 threads call it. Each looks at its share of the voxels and puts its range into thread_ranges; then the 64 become
// one, halving their number with a barrier() between: log2(64) = 6 rounds. Thread 0 writes. memoryBarrierShared() waits for
// nobody, and no thread may miss a barrier.
// [/skip_empty]
void skip_empty(ivec3 block) {
    if (gl_LocalInvocationIndex == 0u) {
        float density = texelFetch(voxels, block * BLOCK_VOXELS, 0).r;
        imageStore(ranges, block, vec4(density, density, 0.0, 0.0));
    }
}
