// A level as it was made, the exact one, and how far their codes are apart: each fitted into a third of the picture.
#include "07_mipmaps/to_linear.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D found, exact;
layout(scalar) uniform ViewerBlock {
    int texture, level;
    float gain;
} viewer;
layout(rgba16f) writeonly uniform image2D result;

const float gap = 8.0;           // pixels around each
const float to_the_later = 1e-4;  // of a texel: a pixel whose centre is on a border belongs to one side on all devices

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(at, size))) return;
    vec2 third = vec2(float(size.x) / 3.0, float(size.y)), texels = vec2(textureSize(exact, 0));
    int which = min(int(float(at.x) / third.x), 2);
    float pixels = min((third.x - 2.0 * gap) / texels.x, (third.y - 2.0 * gap) / texels.y);  // for one texel
    vec2 middle = vec2((float(which) + 0.5) * third.x, 0.5 * third.y);
    vec2 uv = (vec2(at) + 0.5 - middle) / (pixels * texels) + 0.5;
    vec3 code = vec3(0.13);
    if (all(greaterThanEqual(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)))) {
        vec3 a = texelFetch(found, ivec2(uv * vec2(textureSize(found, 0)) + to_the_later), 0).rgb;
        vec3 b = texelFetch(exact, ivec2(uv * texels + to_the_later), 0).rgb;
        code = which == 0 ? a : which == 1 ? b : min(viewer.gain * abs(a - b), vec3(1.0));
    }
    imageStore(result, at, vec4(srgb_to_linear(code), 1.0));
}
