// What fragments get from 04_surface_maps' vertex shaders.
layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec3 world_tangent;
layout(location = 3) in float handedness;
layout(location = 4) in vec2 metres_per_uv;
layout(location = 5) in vec2 uv;
layout(location = 6) flat in uint material_index;
layout(location = 7) flat in uint item;
layout(location = 8) in float cos_uv;

// Tangent space in the world: columns along u, along v, along the normal.
mat3 tangent_space() {
    // Normals of opposite vertices cancel between them: there the mesh's own slope has to do.
    vec3 n = dot(world_normal, world_normal) > 1e-8 ? normalize(world_normal)
                                                    : normalize(cross(dFdy(world_position), dFdx(world_position)));
    vec3 t = world_tangent - n * dot(n, world_tangent);
    t = dot(t, t) > 1e-8 ? normalize(t) : normalize(abs(n.x) < 0.6 ? vec3(0.0, n.z, -n.y) : vec3(-n.z, 0.0, n.x));
    return mat3(t, handedness * cross(n, t), n);
}
