// The BRDF of car paint for a list of directions, as surfaces read it.
#include "14_environment/paint_brdf.glsl"

layout(local_size_x = 64) in;

layout(scalar) readonly buffer CosinesBuffer { vec3 cosines[]; };  // n.l, n.v, l.v
layout(scalar) writeonly buffer FoundBuffer { vec3 found[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(cosines.length())) found[i] = paint_brdf(cosines[i].x, cosines[i].y, cosines[i].z);
}
