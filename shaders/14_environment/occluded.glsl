// Light from all around as far as chapter 05's rays find nothing in the way: for 14_environment/image_light.glsl.
#include "05_shadow_maps/bvh.glsl"

bool light_arrives(vec3 position, vec3 direction) {
    return !any_hit(Ray(position + rays_state.offset_m * direction, 0.0, direction, 1e13));
}
