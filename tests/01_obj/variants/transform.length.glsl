// wrong: normal_to_world(
vec3 position_to_world(mat4 model, vec3 position) {
    return (model * vec4(position, 1.0)).xyz;
}

vec3 normal_to_world(mat3 normal_matrix, vec3 normal) {
    return normal_matrix * normal;
}

vec4 world_to_clip(mat4 view_projection, vec3 world_position) {
    return view_projection * vec4(world_position, 1.0);
}
