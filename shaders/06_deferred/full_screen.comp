// Lighting of every pixel by all lights, or with light volumes by the lights without one.
#include "06_deferred/read_gbuffer.glsl"
#include "06_deferred/put_light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
#if GBUFFER_VOLUMES
layout(scalar) readonly buffer WithoutBuffer {
    uint count;
    uint lights[];
} without_volume;
#endif

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(hdr)))) return;
    float depth = depth_of(at);
    if (depth == 0.0) {
        put_background(at);
        return;
    }
    Pixel p = read_pixel(at, depth);
    Surface surface = surface_of(p, view.eye);
#if GBUFFER_VOLUMES
    Lit lit = Lit(vec3(0.0), vec3(0.0), 0u);
    for (uint i = 0u; i < without_volume.count; ++i)
        add_light(lit, without_volume.lights[i], surface, p.facing, p.position);
#else
    Lit lit = light_surface(surface, p.facing, p.position, 0u, vec4(at, depth, 1.0));
#endif
    put_light(at, p, lit);
}
