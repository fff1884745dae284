// How much of the surroundings' light arrives at the ground: rays towards some directions, that stand for equal shares of it.
#include "05_shadow_maps/bvh.glsl"
#include "14_environment/ground_shadow_data.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) uniform StateBlock { GroundShadowState state; };
layout(scalar) readonly buffer LightBuffer { GroundLight ground_lights[]; };
layout(rgba16f) writeonly uniform image2D arriving;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(arriving);
    if (any(greaterThanEqual(texel, size))) return;
    vec2 place = state.corner + (vec2(texel) + 0.5) / vec2(size) * state.extent;
    vec3 origin = vec3(place.x, state.ground_y + rays_state.offset_m, place.y), sum = vec3(0.0);
    for (int i = 0; i < state.directions; ++i)
        if (!any_hit(Ray(origin, 0.0, ground_lights[i].to_light, 1e13))) sum += ground_lights[i].share;
    imageStore(arriving, texel, vec4(sum, 1.0));
}
