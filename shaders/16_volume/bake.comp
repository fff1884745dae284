// How much of the light from everywhere reaches a texel's place on the mesh. The same directions in each texel: neighbours do
// not differ by chance.
#include "05_shadow_maps/bvh.glsl"
#include "05_shadow_maps/sampling.glsl"
#include "16_volume/bake_ray.glsl"

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
        float seen = 0.0;
        for (uint i = 0u; i < part.z; ++i) {
            vec4 ray = bake_ray(sobol_point(i, 16u));
            vec3 direction = ray.x * x + ray.y * y + ray.z * normal;
            if (!any_hit(Ray(from, 0.0, direction, reach_m))) seen += ray.w;
        }
        open = seen / float(part.z);
    }
    result[texel] = open;
}
// [/bake]
