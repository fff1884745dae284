// Mesh deformation: morph targets, then skinning (glTF 2.0, 3.7.2.2 and 3.7.3).
#include "common/structs.h"

layout(local_size_x = 64) in;

layout(scalar) readonly buffer RestBuffer { Vertex rest[]; };
layout(scalar) writeonly buffer VertexBuffer { Vertex vertices[]; };
layout(scalar) readonly buffer OffsetBuffer { vec3 offsets[]; };  // per target: all positions, then all normals
layout(scalar) readonly buffer WeightBuffer { float morph_weights[]; };
layout(scalar) readonly buffer JointBuffer { uvec4 joints[]; };
layout(scalar) readonly buffer JointWeightBuffer { vec4 joint_weights[]; };
layout(scalar) readonly buffer MatrixBuffer { mat4 joint_matrices[]; };
layout(scalar) uniform DeformBlock {
    uint count;    // number of vertices
    uint targets;  // number of morph targets
    uint has_skin;
} deform;

// [deform]
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= deform.count) return;
    Vertex v = rest[i];
    vec3 normal = v.normal;
    for (uint t = 0u; t < deform.targets; ++t) {
        uint first = 2u * t * deform.count + i;
        v.position += morph_weights[t] * offsets[first];
        normal += morph_weights[t] * offsets[first + deform.count];
    }
    if (deform.has_skin == 1u) {
        mat4 joint = mat4(0.0);
        for (int k = 0; k < 4; ++k) joint += joint_weights[i][k] * joint_matrices[joints[i][k]];
        v.position = (joint * vec4(v.position, 1.0)).xyz;
        normal = mat3(joint) * normal;
    }
    if (dot(normal, normal) > 0.0) v.normal = normalize(normal);
    vertices[i] = v;
}
// [/deform]
