// Irradiance over pi, for each normal the sum over all texels of a small level of the cube: the radiance of a white
// matt surface. There are fewer normals than GPU lanes, so a workgroup shares the sum of one.
#include "common/environment_map.glsl"
#include "14_environment/cube_texel.glsl"
#include "common/structs.h"

const uint LANES = 64u, BRIGHT_WORDS = 6u * 16u * 16u / 32u;  // of a level of at most 16 by 16
layout(local_size_x = 64) in;  // LANES

uniform sampler2DArray radiance;
layout(scalar) uniform SourceLevelBlock { int source_level; };
layout(rgba16f) writeonly uniform image2DArray irradiance;

shared vec4 sums[LANES];  // of light, and of weights
shared uint bright[BRIGHT_WORDS];  // a bit for each texel of the small level

// Light of every LANES-th of the finest texels within one of the small level: a sun is where it is, not in the middle of the
// texel.
vec3 light_within(uvec3 at, vec3 normal, uint side, uint lane) {
    float size = float(textureSize(radiance, 0).x);
    vec3 sum = vec3(0.0);
    for (uint i = lane; i < side * side; i += LANES) {
        uvec3 fine = uvec3(side * at.xy + uvec2(i % side, i / side), at.z);
        float cosine = max(dot(normal, cube_direction(fine, size)), 0.0);
        sum += cosine * texel_solid_angle(fine.xy, size) * texelFetch(radiance, ivec3(fine), 0).rgb;
    }
    return sum;
}

void main() {
    uvec3 texel = gl_WorkGroupID;
    vec3 normal = cube_direction(texel, float(imageSize(irradiance).x));
    uint lane = gl_LocalInvocationIndex, size = uint(textureSize(radiance, source_level).x), texels = 6u * size * size;
    for (uint word = lane; word < BRIGHT_WORDS; word += LANES) bright[word] = 0u;
    barrier();
    vec4 sum = vec4(0.0);
    vec3 all = vec3(0.0);  // of six faces: their last level is one texel
    for (int face = 0; face < 6; ++face) all += texelFetch(radiance, ivec3(0, 0, face), textureQueryLevels(radiance) - 1).rgb;
    float least = 0.005 * 4.0 / 6.0 * 3.14159265 * max(all.r, max(all.g, all.b));  // half a hundredth of all light
    for (uint i = lane; i < texels; i += LANES) {
        uvec3 at = uvec3(i % size, i / size % size, i / (size * size));
        float angle = texel_solid_angle(at.xy, float(size));
        float weight = max(dot(normal, cube_direction(at, float(size))), 0.0) * angle;
        vec3 light = texelFetch(radiance, ivec3(at), source_level).rgb;
        bool is_bright = max(light.r, max(light.g, light.b)) * angle > least;
        if (is_bright) atomicOr(bright[i / 32u], 1u << i % 32u);
        sum += vec4(is_bright ? vec3(0.0) : weight * light, weight);
    }
    barrier();
    // All lanes share the finest texels of each bright one. The bits are read in order, so that the sum has one.
    for (uint word = 0u; word < BRIGHT_WORDS; ++word)
        for (uint rest = bright[word]; rest != 0u; rest &= rest - 1u) {
            uint i = 32u * word + uint(findLSB(rest));
            uvec3 at = uvec3(i % size, i / size % size, i / (size * size));
            sum.rgb += light_within(at, normal, uint(textureSize(radiance, 0).x) / size, lane);
        }
    sums[lane] = sum;
    for (uint half_way = LANES / 2u; half_way > 0u; half_way /= 2u) {
        barrier();
        if (lane < half_way) sums[lane] += sums[lane + half_way];
    }
    // The weights of a few texels do not sum to pi; those of all texels do.
    if (lane == 0u) imageStore(irradiance, ivec3(texel), vec4(min(sums[0].rgb / sums[0].w, LARGEST_HALF), 1.0));
}
