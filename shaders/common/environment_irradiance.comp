// Irradiance: for each normal the sum over a small level of the picture, each texel with its exact solid angle and the
// cosine at its middle. A thread has one texel of each of the six faces, for which it reads the picture once.
#include "common/structs.h"
#include "common/environment_map.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D picture;
layout(scalar) uniform SourceLevelBlock { int source_level; };
layout(rgba16f) writeonly uniform image2DArray irradiance;

void main() {
    uvec2 texel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(ivec2(texel), imageSize(irradiance).xy))) return;
    const float pi = 3.14159265358979;
    vec3 normals[6], sums[6];
    for (uint face = 0; face < 6; ++face) {
        normals[face] = cube_direction(uvec3(texel, face), float(imageSize(irradiance).x));
        sums[face] = vec3(0.0);
    }
    ivec2 size = textureSize(picture, source_level);
    float wide = 2.0 * pi / float(size.x), high = pi / float(size.y);
    for (int row = 0; row < size.y; ++row) {
        float theta = (float(row) + 0.5) * high;
        float solid_angle = wide * (cos(float(row) * high) - cos(float(row + 1) * high));
        for (int column = 0; column < size.x; ++column) {
            float phi = (float(column) + 0.5) * wide - pi;
            vec3 to_light = vec3(sin(phi) * sin(theta), cos(theta), -cos(phi) * sin(theta));
            vec3 light = texelFetch(picture, ivec2(column, row), source_level).rgb * solid_angle;
            for (int face = 0; face < 6; ++face) sums[face] += light * max(dot(normals[face], to_light), 0.0);
        }
    }
    for (int face = 0; face < 6; ++face)
        imageStore(irradiance, ivec3(texel, face), vec4(min(sums[face], LARGEST_HALF), 1.0));
}
