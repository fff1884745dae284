// An environment as nine colours, from a small level of the cube: the threads of one workgroup share the texels.
#include "common/environment_map.glsl"
#include "14_environment/cube_texel.glsl"

layout(local_size_x = 128) in;

uniform sampler2DArray radiance;
layout(scalar) uniform SourceLevelBlock { int source_level; };
layout(scalar) uniform WindowNowBlock { vec3 window_now; };  // factors of degree 0, 1 and 2
layout(scalar) writeonly buffer ShBuffer { vec4 sh_buffer[]; };

shared vec3 sums[128];

void main() {
    uint thread = gl_LocalInvocationIndex, size = uint(textureSize(radiance, source_level).x);
    vec3 own[9];
    for (int i = 0; i < 9; ++i) own[i] = vec3(0.0);
    for (uint n = thread; n < 6u * size * size; n += 128u) {
        uvec3 texel = uvec3(n % size, n / size % size, n / (size * size));
        vec3 d = cube_direction(texel, float(size));
        vec3 light = texel_solid_angle(texel.xy, float(size)) * texelFetch(radiance, ivec3(texel), source_level).rgb;
        own[0] += 0.282095 * light;
        own[1] += 0.488603 * d.y * light;
        own[2] += 0.488603 * d.z * light;
        own[3] += 0.488603 * d.x * light;
        own[4] += 1.092548 * d.x * d.y * light;
        own[5] += 1.092548 * d.y * d.z * light;
        own[6] += 0.315392 * (3.0 * d.z * d.z - 1.0) * light;
        own[7] += 1.092548 * d.x * d.z * light;
        own[8] += 0.546274 * (d.x * d.x - d.y * d.y) * light;
    }
    for (int i = 0; i < 9; ++i) {
        sums[thread] = own[i];
        for (uint count = 64u; count > 0u; count /= 2u) {
            barrier();
            if (thread < count) sums[thread] += sums[thread + count];
        }
        barrier();
        if (thread == 0u) sh_buffer[i] = vec4(sums[0] * window_now[i == 0 ? 0 : i < 4 ? 1 : 2], 0.0);
        barrier();
    }
}
