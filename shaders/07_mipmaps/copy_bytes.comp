// As many bytes as a chain of levels reads and writes, and nothing computed: what a device's memory can do at best.
layout(local_size_x = 256) in;

layout(scalar) readonly buffer FromBuffer { uvec4 from[]; };
layout(scalar) writeonly buffer ToBuffer { uvec4 to[]; };
layout(scalar) uniform CountBlock { uint count; };  // of uvec4; a thread copies four that are far apart

void main() {
    uint stride = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) to[i] = from[i];
}
