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
layout(scalar) readonly buffer FlatBuffer { uvec3 flat_corners[]; };
layout(scalar) readonly buffer DerivativeBuffer { Derivatives derivatives[]; };  // at rest, then each target's offsets
layout(scalar) writeonly buffer FrameBuffer { TangentFrame frames[]; };
layout(scalar) uniform DeformBlock {
    uint count;    // number of vertices
    uint targets;  // number of morph targets
    uint has_skin;
    uint has_flat;
    uint has_frames;
} deform;

// [deform]
mat4 joint_of(uint i) {
    if (deform.has_skin == 0u) return mat4(1.0);
    mat4 joint = mat4(0.0);
    for (int k = 0; k < 4; ++k) joint += joint_weights[i][k] * joint_matrices[joints[i][k]];
    return joint;
}

vec3 position_of(uint i) {
    vec3 position = rest[i].position;
    for (uint t = 0u; t < deform.targets; ++t) position += morph_weights[t] * offsets[2u * t * deform.count + i];
    return (joint_of(i) * vec4(position, 1.0)).xyz;
}

// Normals take the inverse transpose, here times a positive number, so that a joint that flattens has one, too.
mat3 normal_matrix(mat3 m) {
    mat3 cofactors = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    return determinant(m) < 0.0 ? -cofactors : cofactors;
}

vec3 normal_of(uint i, mat3 joint) {
    vec3 normal = rest[i].normal;
    for (uint t = 0u; t < deform.targets; ++t) normal += morph_weights[t] * offsets[(2u * t + 1u) * deform.count + i];
    normal = normal_matrix(joint) * normal;
    if (deform.has_flat == 1u && flat_corners[i].x != flat_corners[i].y) {
        vec3 a = position_of(flat_corners[i].x);
        normal = cross(position_of(flat_corners[i].y) - a, position_of(flat_corners[i].z) - a);
        if (determinant(joint) < 0.0) normal = -normal;  // a mirrored triangle goes round the other way
    }
    return dot(normal, normal) > 0.0 ? normalize(normal) : rest[i].normal;
}
// [/deform]

// The derivatives are offset and go with the joint like positions; the frame follows from them.
TangentFrame frame_of(uint i, mat3 joint, vec3 normal) {
    vec3 per_u = derivatives[i].per_u, per_v = derivatives[i].per_v;
    for (uint t = 0u; t < deform.targets; ++t) {
        per_u += morph_weights[t] * derivatives[(t + 1u) * deform.count + i].per_u;
        per_v += morph_weights[t] * derivatives[(t + 1u) * deform.count + i].per_v;
    }
    per_u = joint * per_u;
    per_v = joint * per_v;
    vec3 in_surface = per_u - normal * dot(normal, per_u);
    TangentFrame frame;
    frame.metres_per_uv = vec2(length(per_u), length(per_v));
    frame.tangent = dot(in_surface, in_surface) > 0.0 ? normalize(in_surface) : vec3(1.0, 0.0, 0.0);
    frame.handedness = dot(cross(normal, frame.tangent), per_v) < 0.0 ? -1.0 : 1.0;
    frame.cos_uv = dot(per_u, per_v) / max(frame.metres_per_uv.x * frame.metres_per_uv.y, 1e-30);
    return frame;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= deform.count) return;
    mat3 joint = mat3(joint_of(i));
    vec3 normal = normal_of(i, joint);
    vertices[i] = Vertex(position_of(i), normal, rest[i].uv);
    if (deform.has_frames == 1u) frames[i] = frame_of(i, joint, normal);
}
