// The next mip level of both images of the ocean: means of 2x2 texels.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) readonly uniform image2DArray finer_moved;
layout(rgba16f) writeonly uniform image2DArray moved;
layout(rgba16f) readonly uniform image2DArray finer_sloped;
layout(rgba16f) writeonly uniform image2DArray sloped;

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(at, imageSize(moved)))) return;
    vec4 a = vec4(0.0), b = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec3 from = ivec3(2 * at.xy + ivec2(i & 1, i >> 1), at.z);
        a += 0.25 * imageLoad(finer_moved, from);
        b += 0.25 * imageLoad(finer_sloped, from);
    }
    imageStore(moved, at, a);
    imageStore(sloped, at, b);
}
