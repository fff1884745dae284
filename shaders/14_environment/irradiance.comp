// Irradiance over pi, for each normal the sum over all texels of a small level of the cube: what a white matt surface
// shows.
#include "11_fractals/environment_map.glsl"
#include "14_environment/cube_texel.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2DArray radiance;
layout(scalar) uniform SourceLevelBlock { int source_level; };
layout(rgba16f) writeonly uniform image2DArray irradiance;

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    if (any(greaterThanEqual(texel.xy, uvec2(imageSize(irradiance).xy)))) return;
    vec3 normal = cube_direction(texel, float(imageSize(irradiance).x));
    int size = textureSize(radiance, source_level).x;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (uint face = 0u; face < 6u; ++face)
        for (uint y = 0u; y < uint(size); ++y)
            for (uint x = 0u; x < uint(size); ++x) {
                vec3 to_light = cube_direction(uvec3(x, y, face), float(size));
                float weight = max(dot(normal, to_light), 0.0) * texel_solid_angle(uvec2(x, y), float(size));
                sum += weight * texelFetch(radiance, ivec3(x, y, face), source_level).rgb;
                weights += weight;
            }
    // The weights of a few texels do not add up to pi; those of all texels do.
    imageStore(irradiance, ivec3(texel), vec4(min(sum / weights, 65504.0), 1.0));
}
