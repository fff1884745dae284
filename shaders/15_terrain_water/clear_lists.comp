// Empty lists.
layout(local_size_x = 64) in;

layout(scalar) writeonly buffer ListHeadsBuffer { uint list_heads[]; };
layout(scalar) writeonly buffer ListCountBuffer { uint list_count[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < list_heads.length()) list_heads[i] = 0u;
    if (i == 0u) list_count[0] = 0u;
}
