// What film and screen add is added to codes, not to light.
#include "common/srgb.glsl"

// Codes from 0 to 1 to linear light: the other way.
vec3 decode_srgb(vec3 code) {
    vec3 low = code / 12.92, high = pow((max(code, 0.0) + 0.055) / 1.055, vec3(2.4));
    return mix(low, high, greaterThan(code, vec3(0.04045)));
}
