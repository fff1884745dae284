// Copies the bytes of a chain of levels without computing: the memory's lower bound.
layout(local_size_x = 256) in;

layout(scalar) readonly buffer FromBuffer { uvec4 from[]; };
layout(scalar) writeonly buffer ToBuffer { uvec4 to[]; };
layout(scalar) uniform CountBlock { uint count; };  // of uvec4; a thread copies four that are far apart

void main() {
    uint stride = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) to[i] = from[i];
}
