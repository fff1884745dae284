// Irradiance over pi, for each normal the sum over all texels of a small level of the cube: the radiance of a white
// matt surface. There are fewer normals than GPU lanes, so a workgroup shares the sum of one.
#include "common/environment_map.glsl"
#include "14_environment/cube_texel.glsl"
#include "common/structs.h"

const uint LANES = 64u;
layout(local_size_x = 64) in;  // LANES

uniform sampler2DArray radiance;
layout(scalar) uniform SourceLevelBlock { int source_level; };
layout(rgba16f) writeonly uniform image2DArray irradiance;

shared vec4 sums[LANES];  // of light, and of weights

void main() {
    uvec3 texel = gl_WorkGroupID;
    vec3 normal = cube_direction(texel, float(imageSize(irradiance).x));
    uint lane = gl_LocalInvocationIndex, size = uint(textureSize(radiance, source_level).x);
    vec4 sum = vec4(0.0);
    for (uint i = lane; i < 6u * size * size; i += LANES) {
        uvec3 at = uvec3(i % size, i / size % size, i / (size * size));
        float weight = max(dot(normal, cube_direction(at, float(size))), 0.0) * texel_solid_angle(at.xy, float(size));
        sum += weight * vec4(texelFetch(radiance, ivec3(at), source_level).rgb, 1.0);
    }
    sums[lane] = sum;
    for (uint half_way = LANES / 2u; half_way > 0u; half_way /= 2u) {
        barrier();
        if (lane < half_way) sums[lane] += sums[lane + half_way];
    }
    // The weights of a few texels do not sum to pi; those of all texels do.
    if (lane == 0u) imageStore(irradiance, ivec3(texel), vec4(min(sums[0].rgb / sums[0].w, LARGEST_HALF), 1.0));
}
