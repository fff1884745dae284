// The frame of a compute shader that shades a visibility buffer: the includer defines seen_radiance(), which reads
// varyings as a fragment shader does.
#include "05_shadow_maps/seen_triangle.glsl"
#include "04_surface_maps/surface_maps.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) writeonly uniform image2D result;

// Textures may move over the surface.
vec2 moved_across(vec2 moved, float time_s) {
    return moving_uv(uv + uv_across, maps.wobble, maps.scroll, time_s) - moved;
}
vec2 moved_down(vec2 moved, float time_s) {
    return moving_uv(uv + uv_down, maps.wobble, maps.scroll, time_s) - moved;
}

// Towards the eye, linear.
vec3 seen_radiance(vec4 frag_coord);

// [shade]
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    vec4 frag_coord;
    if (any(greaterThanEqual(pixel, size)) || !look_up(pixel, size, view.view_projection, frag_coord)) return;
    imageStore(result, pixel, vec4(seen_radiance(frag_coord), 1.0));
}
// [/shade]
