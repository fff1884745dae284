// What fragments get from the vertex shaders, where surfaces are shaded in compute: of one corner of a triangle, and then of
// a place in it.
vec3 world_position, world_normal, world_tangent;
float handedness, cos_uv;
vec2 metres_per_uv, uv;
uint material_index, item;

// How they change from this pixel to the next ones.
vec3 change_across, change_down;  // of the position
vec2 uv_across, uv_down;

vec2 moved_across(vec2 moved, float time_s);
vec2 moved_down(vec2 moved, float time_s);
vec3 position_across() { return change_across; }
vec3 position_down() { return change_down; }
uint drawn_item() { return item; }
