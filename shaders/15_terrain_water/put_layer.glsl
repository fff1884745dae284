// Depth peeling: of the fragments behind the layer before, the nearest passes the depth test. C. Everitt, "Interactive
// Order-Independent Transparency", 2001.
#include "15_terrain_water/tint.glsl"

uniform sampler2D solid_depth;   // reversed
uniform sampler2D nearer_depth;  // of the layer before

layout(location = 0) out vec4 color;
layout(location = 1) out vec4 layer_tint;

void put_surface(vec3 radiance, float alpha, vec3 tint) {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float z = gl_FragCoord.z;
    if (z >= texelFetch(nearer_depth, at, 0).r || z < texelFetch(solid_depth, at, 0).r) discard;
    color = vec4(radiance, alpha);
    layer_tint = vec4(used_tint(tint), 1.0);
}
