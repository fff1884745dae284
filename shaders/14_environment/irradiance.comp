// Irradiance over pi, for each normal the sum over all texels of a small level of the cube: the radiance of a white
// matt surface. There are fewer normals than GPU lanes, so a workgroup shares the sums of some; a texel's direction, angle
// and light, which cost the most, are found once for these.
#include "common/environment_map.glsl"
#include "14_environment/cube_texel.glsl"
#include "common/structs.h"

const uint LANES = 64u, BRIGHT_WORDS = 6u * 16u * 16u / 32u;  // of a level of at most 16 by 16
const uint NORMALS = 8u;  // of a row of the result, as image_light.cpp dispatches
layout(local_size_x = 64) in;  // LANES

uniform sampler2DArray radiance;
layout(scalar) uniform SourceLevelBlock { int source_level; };
layout(rgba16f) writeonly uniform image2DArray irradiance;

shared vec4 sums[LANES];  // of light, and of weights
shared uint bright[BRIGHT_WORDS];  // a bit for each texel of the small level

void main() {
    uvec3 first = uvec3(NORMALS * gl_WorkGroupID.x, gl_WorkGroupID.yz);
    vec3 normals[NORMALS];
    vec4 sum[NORMALS];
    for (uint n = 0u; n < NORMALS; ++n) {
        normals[n] = cube_direction(first + uvec3(n, 0u, 0u), float(imageSize(irradiance).x));
        sum[n] = vec4(0.0);
    }
    uint lane = gl_LocalInvocationIndex, size = uint(textureSize(radiance, source_level).x), texels = 6u * size * size;
    for (uint word = lane; word < BRIGHT_WORDS; word += LANES) bright[word] = 0u;
    barrier();
    vec3 all = vec3(0.0);  // of six faces: their last level is one texel
    for (int face = 0; face < 6; ++face) all += texelFetch(radiance, ivec3(0, 0, face), textureQueryLevels(radiance) - 1).rgb;
    float least = 0.005 * 4.0 / 6.0 * 3.14159265 * max(all.r, max(all.g, all.b));  // half a hundredth of all light
    for (uint i = lane; i < texels; i += LANES) {
        uvec3 at = uvec3(i % size, i / size % size, i / (size * size));
        vec3 direction = cube_direction(at, float(size)), light = texelFetch(radiance, ivec3(at), source_level).rgb;
        float angle = texel_solid_angle(at.xy, float(size));
        bool is_bright = max(light.r, max(light.g, light.b)) * angle > least;
        if (is_bright) atomicOr(bright[i / 32u], 1u << i % 32u);
        for (uint n = 0u; n < NORMALS; ++n) {
            float weight = max(dot(normals[n], direction), 0.0) * angle;
            sum[n] += vec4(is_bright ? vec3(0.0) : weight * light, weight);
        }
    }
    barrier();
    // All lanes share the finest texels within each bright one: a sun is where it is, not in the middle of the texel. The
    // bits are read in order, so that the sum has one.
    float finest = float(textureSize(radiance, 0).x);
    uint side = uint(finest) / size;
    for (uint word = 0u; word < BRIGHT_WORDS; ++word)
        for (uint rest = bright[word]; rest != 0u; rest &= rest - 1u) {
            uint i = 32u * word + uint(findLSB(rest));
            uvec3 at = uvec3(i % size, i / size % size, i / (size * size));
            vec3 middle = cube_direction(at, float(size)), within[NORMALS];
            bool is_in_front = false;  // its corners are at most sqrt(2) / size away from its middle
            for (uint n = 0u; n < NORMALS; ++n) {
                within[n] = vec3(0.0);
                is_in_front = is_in_front || dot(normals[n], middle) > -1.5 / float(size);
            }
            if (!is_in_front) continue;
            for (uint k = lane; k < side * side; k += LANES) {
                uvec3 fine = uvec3(side * at.xy + uvec2(k % side, k / side), at.z);
                vec3 direction = cube_direction(fine, finest), light = texelFetch(radiance, ivec3(fine), 0).rgb;
                float angle = texel_solid_angle(fine.xy, finest);
                for (uint n = 0u; n < NORMALS; ++n) within[n] += max(dot(normals[n], direction), 0.0) * angle * light;
            }
            for (uint n = 0u; n < NORMALS; ++n) sum[n].rgb += within[n];
        }
    for (uint n = 0u; n < NORMALS; ++n) {
        barrier();  // the normal before has been read
        sums[lane] = sum[n];
        for (uint half_way = LANES / 2u; half_way > 0u; half_way /= 2u) {
            barrier();
            if (lane < half_way) sums[lane] += sums[lane + half_way];
        }
        // The weights of a few texels do not sum to pi; those of all texels do.
        if (lane == 0u)
            imageStore(irradiance, ivec3(first + uvec3(n, 0u, 0u)), vec4(min(sums[0].rgb / sums[0].w, LARGEST_HALF), 1.0));
    }
}
