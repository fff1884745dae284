// The Sun: limb darkening, granules, spots.
#include "16_volume/noise_4d.glsl"

// D. Hestroffer and C. Magnan, Astronomy and Astrophysics 333, 1998: µ^α, α = 0.292 / λ - 0.023 with λ in µm: here 0.65, 0.55, 0.45.
vec3 limb_darkening(float mu) { return pow(vec3(max(mu, 1e-3)), vec3(0.426, 0.508, 0.626)); }

// Noise over space and time, -1 to 1.
float boiling(vec3 at, float moment) {
    vec3 whole = floor(at);
    float cell = floor(moment);
    return noise_4d(ivec4(ivec3(whole), int(cell)), vec4(at - whole, moment - cell));
}

// A pixel that is larger than a cell sees none of it.
float seen_noise(vec3 place, float cells, float moment, float footprint_rad) {
    float keep = 1.0 - smoothstep(0.3, 0.8, footprint_rad * cells);
    return keep > 0.0 ? keep * boiling(place * cells, moment) : 0.0;
}

float spots(vec3 place) {
    float dark = 0.0;
    for (int i = 0; i < 16; ++i) {
        float north = float(i / 2 % 2) * 2.0 - 1.0, turn = 2.4 * float(i / 2) + 0.09 * float(i % 2) + 0.5 * sin(9.0 * float(i / 2));
        float latitude = north * (0.14 + 0.04 * float(i % 5)), size = 0.009 + 0.022 * fract(0.618 * float(i * i));
        vec3 middle = vec3(cos(latitude) * sin(turn), sin(latitude), cos(latitude) * cos(turn));
        float away = length(place - middle) / size + 0.35 * boiling(place * 70.0, float(i));
        dark = max(dark, 0.55 * smoothstep(1.9, 1.5, away) + 0.40 * smoothstep(0.9, 0.7, away));
    }
    return dark;
}

// Radiance; `place` has unit length. Granules are 1,000 km wide, of which a whole picture of the Sun shows a mottling; the network
// of supergranules is 30,000 km wide. As telescopes' pictures are printed, more contrasted than the eye would see it.
vec3 sun_surface(vec3 place, float mu, float moment, float footprint_rad) {
    float granules = 0.10 * seen_noise(place, 420.0, moment, footprint_rad) + 0.10 * seen_noise(place, 160.0, 0.5 * moment, footprint_rad) +
                     0.07 * seen_noise(place, 45.0, 0.1 * moment, footprint_rad);
    vec3 light = limb_darkening(mu) * (1.0 + granules) * (1.0 - spots(place));
    return light * vec3(1.0, 0.54, 0.13);
}
