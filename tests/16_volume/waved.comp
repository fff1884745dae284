// For the test of waves: how far each place of a grid is displaced.
#include "16_volume/volume_inputs.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(scalar) writeonly buffer ResultBuffer { vec3 result[]; };

void main() {
    uvec3 n = gl_NumWorkGroups * gl_WorkGroupSize, i = gl_GlobalInvocationID;
    vec3 at = vec3(i) / vec3(n);
    result[i.x + n.x * (i.y + n.y * i.z)] = waved(at) - at;
}
