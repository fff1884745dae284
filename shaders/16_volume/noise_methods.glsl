// Noise over space and time by each method. -1 to 1 or a little less.
#include "16_volume/noise_4d.glsl"
#include "16_volume/simplex_4d.glsl"

#if VOLUME_NOISE == VOLUME_NOISE_LATTICE
float moving_noise(vec3 at, NoiseMoment moment) {
    vec3 whole = floor(at);
    return noise_4d(ivec4(ivec3(whole), moment.cell) + ivec4(moment.seed, 0, 0, 0), vec4(at - whole, moment.time));
}
#elif VOLUME_NOISE == VOLUME_NOISE_SIMPLEX
float moving_noise(vec3 at, NoiseMoment moment) { return simplex_4d(at, moment); }
#else
// A volume of random texels stands for all times: each moment of the lattice reads it elsewhere. Two reads instead of 16;
// the filter mixes in steps of 1/256 of a texel.
uniform sampler3D volume_noise;
float at_moment(vec3 place, int moment, int seed) {
    ivec3 shift = ivec3(31.0 * vec3(lattice_4d(ivec4(moment, 1, seed, 0)), lattice_4d(ivec4(moment, 2, seed, 0)),
                                    lattice_4d(ivec4(moment, 3, seed, 0))));
    return textureLod(volume_noise, (place + vec3(shift) + 0.5) / vec3(textureSize(volume_noise, 0)), 0.0).r;
}
float moving_noise(vec3 at, NoiseMoment moment) {
    vec3 whole = floor(at), f = at - whole, place = whole + f * f * f * (f * (6.0 * f - 15.0) + 10.0);
    float t = moment.time, s = t * t * t * (t * (6.0 * t - 15.0) + 10.0);
    return mix(at_moment(place, moment.cell, moment.seed), at_moment(place, moment.cell + 1, moment.seed), s);
}
#endif
