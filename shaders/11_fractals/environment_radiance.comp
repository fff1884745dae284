// One level of the cube: from the level of the picture whose texels are as large, by a cubic B-spline, whose magnified
// picture has no corners as a linear filter's has (Sigg and Hadwiger, GPU Gems 2, 2005, chapter 20: four linear reads).
#include "11_fractals/environment_map.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D picture;
layout(rgba16f) writeonly uniform image2DArray level;

// Half of a spline's weights along one axis: two reads at `at`, which weigh 1 - share and share.
struct Reads {
    vec2 at;
    float share;
};

Reads reads_along(float position) {
    float f = fract(position - 0.5), first = position - f;  // the middle of the texel before
    float w0 = (1.0 - f) * (1.0 - f) * (1.0 - f), w1 = 4.0 - 6.0 * f * f + 3.0 * f * f * f;
    float w3 = f * f * f, w2 = 6.0 - w0 - w1 - w3;
    return Reads(first + vec2(w1 / (w0 + w1) - 1.0, 1.0 + w3 / (w2 + w3)), (w2 + w3) / 6.0);
}

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    ivec3 size = imageSize(level);
    if (any(greaterThanEqual(ivec2(texel.xy), size.xy))) return;
    // A face is a quarter of the way around.
    float lod = max(log2(float(textureSize(picture, 0).x) / (4.0 * float(size.x))), 0.0);
    lod = min(round(lod), float(textureQueryLevels(picture) - 1));
    vec2 texels = vec2(textureSize(picture, int(lod)));
    vec2 position = environment_uv(cube_direction(texel, float(size.x))) * texels;
    Reads x = reads_along(position.x), y = reads_along(position.y);
    vec2 rows = clamp(y.at, 0.5, texels.y - 0.5) / texels.y, columns = x.at / texels.x;  // columns go around
    vec3 above = mix(textureLod(picture, vec2(columns.x, rows.x), lod).rgb,
                     textureLod(picture, vec2(columns.y, rows.x), lod).rgb, x.share);
    vec3 below = mix(textureLod(picture, vec2(columns.x, rows.y), lod).rgb,
                     textureLod(picture, vec2(columns.y, rows.y), lod).rgb, x.share);
    imageStore(level, ivec3(texel), vec4(mix(above, below, y.share), 1.0));
}
