// The first level of a cube of radiance from an equirectangular picture: of each texel the mean of four places in it.
#include "common/environment_map.glsl"
#include "14_environment/direction_to_equirect.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D picture;
layout(scalar) uniform LimitBlock { float limit; };  // radiance above it is cut off: half floats end at 65504
layout(rgba16f) writeonly uniform image2DArray cube;

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    float size = float(imageSize(cube).x);
    if (any(greaterThanEqual(texel.xy, uvec2(imageSize(cube).xy)))) return;
    vec2 texels = vec2(textureSize(picture, 0));
    // A face spans a quarter turn. The level with texels as wide as a quarter of this one's.
    float lod = max(log2(texels.x / (8.0 * size)), 0.0);
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < 4u; ++i) {
        vec2 uv = direction_to_equirect(cube_direction(uvec3(2u * texel.xy + uvec2(i & 1u, i >> 1), texel.z), 2.0 * size));
        // Around +z the picture goes on at its other edge; at the poles it does not.
        float border = 0.5 * exp2(ceil(lod)) / texels.y;
        sum += min(textureLod(picture, vec2(uv.x, clamp(uv.y, border, 1.0 - border)), lod).rgb, limit);
    }
    imageStore(cube, ivec3(texel), vec4(0.25 * sum, 1.0));
}
