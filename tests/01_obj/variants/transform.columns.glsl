// right
vec3 position_to_world(mat4 model, vec3 position) {
    return mat3(model) * position + model[3].xyz;
}

vec3 normal_to_world(mat3 normal_matrix, vec3 normal) {
    return normalize(normal * transpose(normal_matrix));
}

vec4 world_to_clip(mat4 view_projection, vec3 world_position) {
    return view_projection * vec4(world_position, 1.0);
}
