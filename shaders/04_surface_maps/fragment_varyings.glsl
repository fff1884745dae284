// What fragments get from the vertex shaders. Where surfaces are shaded in compute, another file stands in for this one.
layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec3 world_tangent;
layout(location = 3) in float handedness;
layout(location = 4) in vec2 metres_per_uv;
layout(location = 5) in vec2 uv;
layout(location = 6) flat in uint material_index;
layout(location = 7) flat in uint item;
layout(location = 8) in float cos_uv;

// How they change from this pixel to the next ones; `moved` is where moving_uv() has uv.
vec2 moved_across(vec2 moved, float time_s) { return dFdx(moved); }
vec2 moved_down(vec2 moved, float time_s) { return dFdy(moved); }
vec3 position_across() { return dFdx(world_position); }
vec3 position_down() { return dFdy(world_position); }
