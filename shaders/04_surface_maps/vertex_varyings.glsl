// What vertices hand to fragments. Where surfaces are shaded in compute, another file stands in for this one.
layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) out vec3 world_tangent;
layout(location = 3) out float handedness;
layout(location = 4) out vec2 metres_per_uv;
layout(location = 5) out vec2 uv;
layout(location = 6) flat out uint material_index;
layout(location = 7) flat out uint item;  // which of the scene's items
layout(location = 8) out float cos_uv;
invariant gl_Position;                    // the depth pass and the shading pass agree to the last bit

uint drawn_item() { return gl_InstanceIndex; }
