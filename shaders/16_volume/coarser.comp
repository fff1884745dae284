// The next level of the pyramid over the blocks: one is occupied where any of the eight in it is.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
uniform sampler3D finer;
layout(r8) writeonly uniform image3D result;

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID), last = textureSize(finer, 0) - 1;
    if (any(greaterThanEqual(at, imageSize(result)))) return;
    float most = 0.0;
    for (int i = 0; i < 8; ++i)
        most = max(most, texelFetch(finer, min(2 * at + ((ivec3(i) >> ivec3(0, 1, 2)) & 1), last), 0).r);
    imageStore(result, at, vec4(most));
}
