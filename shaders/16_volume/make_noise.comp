// The lattice's numbers in a texture, for noise that reads instead of computing.
#include "16_volume/lattice_4d.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(r16f) writeonly uniform image3D result;

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID);
    if (all(lessThan(at, imageSize(result)))) imageStore(result, at, vec4(lattice_4d(ivec4(at, 0))));
}
