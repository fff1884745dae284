// Six mip levels of both images of the ocean in one dispatch: each workgroup makes those of 64×64 texels.
layout(local_size_x = 16, local_size_y = 16) in;

layout(rgba16f) readonly uniform image2DArray finer_moved;
layout(rgba16f) writeonly uniform image2DArray moved[6];
layout(rgba16f) readonly uniform image2DArray finer_sloped;
layout(rgba16f) writeonly uniform image2DArray sloped[6];
layout(scalar) uniform OceanHalveBlock { int made; } ocean_halve;  // how many of the six there are

struct Both {
    vec4 moved, sloped;
};
shared Both means[16][16];

ivec2 corner(int i) { return ivec2(i & 1, i >> 1); }

// A level holds half floats, and the next one their means.
vec4 stored(vec4 v) { return vec4(unpackHalf2x16(packHalf2x16(v.xy)), unpackHalf2x16(packHalf2x16(v.zw))); }

Both mean(Both four[4]) {
    Both sum = Both(vec4(0.0), vec4(0.0));
    for (int i = 0; i < 4; ++i) {
        sum.moved += 0.25 * four[i].moved;
        sum.sloped += 0.25 * four[i].sloped;
    }
    return Both(stored(sum.moved), stored(sum.sloped));
}

void keep(int level, ivec2 at, Both value) {
    if (level >= ocean_halve.made || any(greaterThanEqual(at, imageSize(finer_moved).xy >> (level + 1)))) return;
    ivec3 place = ivec3(at, gl_WorkGroupID.z);
    imageStore(moved[level], place, value.moved);
    imageStore(sloped[level], place, value.sloped);
}

// [ocean_halve]
void main() {
    ivec2 group = ivec2(gl_WorkGroupID.xy), own = ivec2(gl_LocalInvocationID.xy);
    // Two levels in registers: four texels of the first, one of the second.
    Both first[4];
    for (int i = 0; i < 4; ++i) {
        ivec2 at = 2 * (16 * group + own) + corner(i);
        Both finer[4];
        for (int k = 0; k < 4; ++k) {
            ivec3 from = ivec3(2 * at + corner(k), gl_WorkGroupID.z);
            finer[k] = Both(imageLoad(finer_moved, from), imageLoad(finer_sloped, from));
        }
        first[i] = mean(finer);
        keep(0, at, first[i]);
    }
    Both value = mean(first);
    keep(1, 16 * group + own, value);
    means[own.y][own.x] = value;

    // Four levels in shared memory, from 8×8 to 1×1.
    for (int level = 2, side = 8; side > 0; ++level, side /= 2) {
        barrier();  // writes before reads
        bool mine = all(lessThan(own, ivec2(side)));
        Both four[4];
        for (int i = 0; i < 4; ++i) {
            ivec2 at = (2 * own + corner(i)) & 15;
            four[i] = means[at.y][at.x];
        }
        value = mean(four);
        barrier();  // reads before writes
        if (mine) {
            means[own.y][own.x] = value;
            keep(level, side * group + own, value);
        }
    }
}
// [/ocean_halve]
