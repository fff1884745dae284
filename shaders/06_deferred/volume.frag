// One light, added to the surfaces within its volume.
#include "06_deferred/read_gbuffer.glsl"
#include "06_deferred/reflected.glsl"

layout(location = 0) flat in uint light;
layout(location = 0) out vec4 color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = depth_of(at);
    if (depth == 0.0) discard;  // no surface: the volume extends beyond the far plane
    Pixel p = read_pixel(at, depth);
    Lit lit = Lit(vec3(0.0), vec3(0.0), 0u);
    add_light(lit, light, surface_of(p, view.eye), p.facing, p.position);
    color = vec4(min(reflected(p, lit), LARGEST_HALF), lit.lights);
}
