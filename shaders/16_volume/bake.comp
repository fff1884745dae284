// How much of the light from everywhere reaches a texel's place on the mesh: rays that are as dense as the cosine. The same
// directions in each texel: neighbours do not differ by chance.
#include "05_shadow_maps/bvh.glsl"
#include "05_shadow_maps/sampling.glsl"

layout(local_size_x = 64) in;
layout(scalar) readonly buffer PlaceBuffer { vec4 places[]; };    // metres; w: 0 where no triangle is
layout(scalar) readonly buffer NormalBuffer { vec4 normals[]; };  // unit length
layout(scalar) writeonly buffer ResultBuffer { float result[]; };
layout(scalar) uniform PartBlock { uvec4 part; };  // first texel, texels, rays
layout(scalar) uniform ReachBlock { float reach_m; };

// [bake]
void main() {
    if (gl_GlobalInvocationID.x >= part.y) return;
    uint texel = part.x + gl_GlobalInvocationID.x;
    vec3 normal = normals[texel].xyz, x, y;
    float open = 1.0;
    if (places[texel].w > 0.0) {
        basis_of(normal, x, y);
        vec3 from = above(places[texel].xyz, normal);
        uint seen = 0u;
        for (uint i = 0u; i < part.z; ++i) {
            vec2 at = on_disc(sobol_point(i, 16u));
            vec3 direction = at.x * x + at.y * y + sqrt(max(1.0 - dot(at, at), 0.0)) * normal;
            if (!any_hit(Ray(from, 0.0, direction, reach_m))) ++seen;
        }
        open = float(seen) / float(part.z);
    }
    result[texel] = open;
}
// [/bake]
