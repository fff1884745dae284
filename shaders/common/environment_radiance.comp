// One level of the cube: from the picture's level with texels as large, by a cubic B-spline.
#include "common/cubic_picture.glsl"
#include "common/environment_map.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D picture;
layout(rgba16f) writeonly uniform image2DArray level;

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    ivec3 size = imageSize(level);
    if (any(greaterThanEqual(ivec2(texel.xy), size.xy))) return;
    // A face is a quarter of the way around.
    float lod = max(log2(float(textureSize(picture, 0).x) / (4.0 * float(size.x))), 0.0);
    lod = min(round(lod), float(textureQueryLevels(picture) - 1));
    vec2 uv = environment_uv(cube_direction(texel, float(size.x)));
    imageStore(level, ivec3(texel), vec4(cubic_picture(picture, uv, lod), 1.0));
}
