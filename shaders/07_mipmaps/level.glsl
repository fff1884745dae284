// For filters that make one level in a dispatch: one thread for each of its texels.
#include "07_mipmaps/source.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

writeonly uniform image2DArray level;

// False for threads beyond the level's edge.
bool begin(out ivec2 at) {
    at = ivec2(gl_GlobalInvocationID.xy);
    layer = int(gl_GlobalInvocationID.z);
    return all(lessThan(at, imageSize(level).xy));
}

void end(ivec2 at, vec4 mean) { imageStore(level, ivec3(at, layer), encode(mean)); }
