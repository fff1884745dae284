// Six mip levels of both images of the ocean in one dispatch: each workgroup makes those of 64×64 texels.
layout(local_size_x = 256) in;

layout(rgba16f) readonly uniform image2DArray finer_moved;
layout(rgba16f) coherent uniform image2DArray moved[6];
layout(rgba16f) readonly uniform image2DArray finer_sloped;
layout(rgba16f) coherent uniform image2DArray sloped[6];
layout(scalar) uniform OceanHalveBlock { int made; } ocean_halve;  // how many of the six there are

// A level holds half floats, and the next one their means: they are read as they were stored.
void halve(int level, ivec2 at) {
    ivec3 place = ivec3(at, gl_WorkGroupID.z);
    vec4 a = vec4(0.0), b = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec3 from = ivec3(2 * at + ivec2(i & 1, i >> 1), place.z);
        a += 0.25 * (level == 0 ? imageLoad(finer_moved, from) : imageLoad(moved[max(level - 1, 0)], from));
        b += 0.25 * (level == 0 ? imageLoad(finer_sloped, from) : imageLoad(sloped[max(level - 1, 0)], from));
    }
    imageStore(moved[level], place, a);
    imageStore(sloped[level], place, b);
}

// [ocean_halve]
void main() {
    ivec2 size = imageSize(finer_moved).xy;
    for (int level = 0, side = 32; level < ocean_halve.made; ++level, side /= 2) {
        for (int i = int(gl_LocalInvocationIndex); i < side * side; i += 256) {
            ivec2 at = side * ivec2(gl_WorkGroupID.xy) + ivec2(i % side, i / side);
            if (all(lessThan(at, size >> (level + 1)))) halve(level, at);
        }
        memoryBarrierImage();
        barrier();
    }
}
// [/ocean_halve]
