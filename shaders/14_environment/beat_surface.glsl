// The displaced sphere: a height above each direction from its centre, and the normal of the surface that results.
#include "14_environment/beat_data.h"
#include "14_environment/image_light.glsl"

layout(scalar) uniform BeatNowBlock { BeatNow beat_now; };

struct SphereHeight {
    float value;    // a share of the radius
    vec3 gradient;  // along the unit sphere, per unit of its arc
};

// [waves]
// Plane waves along the six axes of an icosahedron: their sum has its symmetry on the sphere, and no pole. 0 to 1; the
// larger the exponent, the narrower the peaks and the wider the valleys.
SphereHeight waves(vec3 n, float frequency, float exponent) {
    const float a = 0.5257311121, b = 0.8506508084;
    const vec3 axes[6] = vec3[](vec3(0, a, b), vec3(0, -a, b), vec3(a, b, 0), vec3(-a, b, 0), vec3(b, 0, a), vec3(b, 0, -a));
    float sum = 0.0;
    vec3 slope = vec3(0.0);
    for (int i = 0; i < 6; ++i) {
        float along = frequency * dot(n, axes[i]);
        sum += cos(along);
        slope -= frequency * sin(along) * axes[i];
    }
    float u = max(sum / 12.0 + 0.5, 1e-6), power = pow(u, exponent);
    return SphereHeight(power, exponent * power / u / 12.0 * slope);
}
// [/waves]

// [brightness]
// Doublings of the surroundings' radiance over its mean. Their logarithm, for the brightest texel of a sky has 300 to
// 15,000 times the mean, and of a blurred level, for the sphere's triangles cannot follow single texels.
float doublings(vec3 n) {
    vec3 light = textureLod(image_light_radiance, environment_space(n), beat_now.blur).rgb;
    const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);
    float mean = 0.282095 * dot(image_light_sh[0].rgb, luminance);
    return clamp(log2(max(dot(light, luminance), 1e-6) / max(mean, 1e-6)), -6.0, 6.0);
}
// [/brightness]

SphereHeight band_heights(vec3 n) {
    const vec3 exponents = vec3(2.0, 6.0, 4.0);
    SphereHeight sum = SphereHeight(0.0, vec3(0.0));
    for (int band = 0; band < 3; ++band) {
        SphereHeight one = waves(beat_now.from_world * n, beat_now.frequencies[band], exponents[band]);
        sum.value += beat_now.heights[band] * one.value;
        sum.gradient += beat_now.heights[band] * one.gradient;
    }
    sum.gradient = transpose(beat_now.from_world) * sum.gradient;
    return sum;
}

float height_above(vec3 n) { return band_heights(n).value + beat_now.brightness * doublings(n); }

vec3 place_above(vec3 n) { return (1.0 + height_above(n)) * n; }

// [normal]
// Of the surface (1 + h(n)) n, unit length. The waves' gradient is known; that of the surroundings is measured, a texel
// of the level that is read to either side.
vec3 displaced_normal(vec3 n) {
#if BEAT_NORMAL == BEAT_NORMAL_SPHERE
    return n;
#elif BEAT_NORMAL == BEAT_NORMAL_DIFFERENCES
    const float step = 2e-3;
    mat3 frame = frame_around(n);
    vec3 right = place_above(normalize(n + step * frame[0])) - place_above(normalize(n - step * frame[0]));
    vec3 up = place_above(normalize(n + step * frame[1])) - place_above(normalize(n - step * frame[1]));
    return normalize(cross(right, up));
#else
    SphereHeight bands = band_heights(n);
    vec3 gradient = bands.gradient;
    if (beat_now.brightness != 0.0) {
        float step = exp2(beat_now.blur) / image_light_state.texels;
        mat3 frame = frame_around(n);
        for (int i = 0; i < 2; ++i)
            gradient += beat_now.brightness * frame[i] *
                        (doublings(normalize(n + step * frame[i])) - doublings(normalize(n - step * frame[i]))) /
                        (2.0 * atan(step));
    }
    gradient -= dot(gradient, n) * n;
    return normalize(n - gradient / (1.0 + bands.value + beat_now.brightness * doublings(n)));
#endif
}
// [/normal]
