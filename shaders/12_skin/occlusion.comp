// How much of the sky a point of the surface sees, by rays that are as dense as the cosine.
#include "05_shadow_maps/bvh.glsl"
#include "05_shadow_maps/sampling.glsl"
#include "12_skin/charts.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D skin_normal;
layout(rgba16f) writeonly uniform image2D result;
layout(scalar) uniform OcclusionRaysBlock { uint occlusion_rays; };

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(result)))) return;
    vec4 own = place_at(texel);
    vec3 normal = texelFetch(skin_normal, texel, 0).xyz, x, y, bent = vec3(0.0);
    float seen = 0.0;
    if (own.w > 0.0) {
        basis_of(normal, x, y);
        for (uint i = 0u; i < occlusion_rays; ++i) {
            vec2 at = on_disc(sobol_point(i, seed_of(uvec2(texel), 0u)));
            vec3 direction = at.x * x + at.y * y + sqrt(max(1.0 - dot(at, at), 0.0)) * normal;
            if (!any_hit(Ray(above(own.xyz, normal), 0.0, direction, on_and_on))) seen += 1.0;
        }
        seen /= float(occlusion_rays);
    }
    imageStore(result, texel, vec4(seen, 0.0, 0.0, own.w));
}
