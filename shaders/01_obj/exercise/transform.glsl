// Exercise 01.transform: from the model's own space to the world, and from the world to the screen.
// Until you fill it in, every object stands at the origin, unturned and unscaled.

// [position_to_world]
// The position in the world. `model` moves points from the object's space to the world. A point has w = 1, so that the
// translation in the matrix's last column counts.
// [/position_to_world]
vec3 position_to_world(mat4 model, vec3 position) {
    return position;
}

// [normal_to_world]
// The direction of the normal in the world, of length 1. `normal_matrix` is the inverse transpose of the model
// matrix's upper 3×3: with it a normal stays perpendicular to its surface when the object is stretched.
// [/normal_to_world]
vec3 normal_to_world(mat3 normal_matrix, vec3 normal) {
    return normal;
}

// [world_to_clip]
// The position in clip space, which the rasteriser divides by w.
// [/world_to_clip]
vec4 world_to_clip(mat4 view_projection, vec3 world_position) {
    return view_projection * vec4(world_position, 1.0);
}
