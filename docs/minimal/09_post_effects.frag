// [minimal]
#version 460
// From rendered light to the codes of a screen in one pass: lens, exposure, tones, grain. One run for each pixel.
layout(location = 0) in vec2 uv;  // 0 to 1 over the picture
layout(location = 0) out vec4 code;  // 0 to 1, into a render target that is not sRGB: this shader encodes
layout(binding = 0) uniform sampler2D picture;  // linear light
layout(push_constant) uniform Lens { float stops, white, contrast, grain, aspect, half_height, time_s; };

// A simple lens is darker towards the corners by the fourth power of the cosine of the angle to its axis. `across` is
// the tangent of that angle: 0 in the middle, half_height at the upper edge.
float lens_falloff(float across) {
    float square = 1.0 / (1.0 + across * across);  // of the cosine
    return square * square;
}

// Light without an upper limit to 0 ... 1: small values stay as they are, `white` becomes 1 (E. Reinhard et al., 2002).
// The luminance is mapped and the colour follows, so that hues keep.
vec3 tone(vec3 light, float white) {
    float l = dot(light, vec3(0.2126, 0.7152, 0.0722));
    return light * (1.0 + l / (white * white)) / (1.0 + l);
}

// More or less contrast around middle grey, 18%, which stays: a power, that is a straight line in stops.
vec3 contrasted(vec3 light, float contrast) { return 0.18 * pow(max(light, 0.0) / 0.18, vec3(contrast)); }

// Linear light to sRGB's codes: finer steps where it is dark, as the eye wants them (IEC 61966-2-1).
vec3 encoded(vec3 light) {
    vec3 l = clamp(light, 0.0, 1.0);
    return mix(1.055 * pow(l, vec3(1.0 / 2.4)) - 0.055, 12.92 * l, lessThanEqual(l, vec3(0.0031308)));
}

// An even random number, 0 to 1, for a pixel (M. Jarzynski and M. Olano, JCGT 9(3), 2020: pcg2d).
float noise(uvec2 pixel) {
    uvec2 v = pixel * 1664525u + 1013904223u;
    v += v.yx * 1664525u;
    v ^= v >> 16u;
    v += v.yx * 1664525u;
    v ^= v >> 16u;
    return float(v.x) / 4294967296.0;
}

void main() {
    vec2 across = (2.0 * uv - 1.0) * half_height * vec2(aspect, 1.0);
    vec3 light = textureLod(picture, uv, 0.0).rgb * exp2(stops) * lens_falloff(length(across));
    vec3 shown = encoded(contrasted(tone(light, white), contrast));
    // Grain: as strong as the knob says, and at least the half step that hides the edges of 256 shades (dithering).
    float random = noise(uvec2(gl_FragCoord.xy) + uvec2(1000.0 * time_s, 0)) - 0.5;
    code = vec4(shown + random * max(grain, 1.0 / 255.0), 1.0);
}
// [/minimal]
