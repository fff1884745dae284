// Which parts of a ray are empty, by a pyramid of blocks.
#if VOLUME_METHOD == VOLUME_METHOD_SKIPPING || VOLUME_SHOW == VOLUME_SHOW_BLOCKS
uniform sampler3D volume_blocks;

// Along the volume's axes, of a step of 1 m along the ray; never 0.
vec3 voxels_a_metre(vec3 along) {
    vec3 speed = 0.5 * volume_now.size / volume_now.half_m * (volume_now.to_volume * along);
    return mix(speed, vec3(1e-12), lessThan(abs(speed), vec3(1e-12)));
}

// [skip]
// Returns where the ray leaves the block around a place, in metres from the ray's beginning. The place is `voxel`, in voxels,
// and `t` metres from that beginning; `speed` is the ray's direction in voxels per metre. The block is the largest empty one
// (`empty` is true) or, if none is empty, the smallest.
float block_leaves(vec3 voxel, vec3 speed, float t, out bool empty) {
    ivec3 block = clamp(ivec3(floor(voxel / float(BLOCK_VOXELS))), ivec3(0), textureSize(volume_blocks, 0) - 1);
    int levels = int(255.0 * texelFetch(volume_blocks, block, 0).r + 0.5), level = max(levels - 1, 0);
    empty = levels > 0;
    ivec3 face = ((block >> level) + ivec3(greaterThan(speed, vec3(0.0)))) << level;
    vec3 way = max((vec3(face * BLOCK_VOXELS) - voxel) / speed, 0.0);
    return t + min(way.x, min(way.y, way.z));
}
// [/skip]
#endif
