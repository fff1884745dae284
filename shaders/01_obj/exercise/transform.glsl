// Exercise 01.transform: from object space to world space, and from world space to clip space.
// Starter: every object stands at the origin, neither rotated nor scaled.

// [position_to_world]
// The point `position` (object space, metres) in world space. `model` is the matrix from
// object space to world space. A point is multiplied as (x, y, z, 1): with w = 1 the
// translation in the last column of the matrix applies.
// [/position_to_world]
vec3 position_to_world(mat4 model, vec3 position) {
    return position;
}

// [normal_to_world]
// The unit normal in world space. `normal_matrix` is the inverse transpose of the upper 3×3
// of the model matrix. It keeps a normal perpendicular to its surface when the object is
// stretched, but it does not keep the length: the result must be a unit vector.
// [/normal_to_world]
vec3 normal_to_world(mat3 normal_matrix, vec3 normal) {
    return normal;
}

// [world_to_clip]
// The homogeneous clip-space position of a point in world space. The rasteriser divides it
// by w.
// [/world_to_clip]
vec4 world_to_clip(mat4 view_projection, vec3 world_position) {
    return view_projection * vec4(world_position, 1.0);
}
