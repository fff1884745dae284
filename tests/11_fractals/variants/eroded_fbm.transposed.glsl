// right, in its pictures too
#include "11_fractals/noise_jet.glsl"

vec3 eroded_fbm(ivec2 cell, vec2 offset, float octaves, float erosion, float gain) {
    vec2 steepness = vec2(0.0);                         // the sum of gradients
    mat2 bend = mat2(0.0), scale = mat2(1.0);           // how it changes with the place; of this octave's cells
    vec3 sum = vec3(0.0);
    float amplitude = 1.0;
    for (int k = 0; float(k) < octaves; ++k) {
        settle(cell, offset);
        NoiseJet noise = noise_jet(cell, offset);
        float share = min(octaves - float(k), 1.0);
        steepness += share * noise.gradient;
        bend += share * noise.hessian * scale;
        float weight = 1.0 / (1.0 + erosion * dot(steepness, steepness));
        vec2 weight_slope = -2.0 * erosion * weight * weight * (transpose(bend) * steepness);
        sum += amplitude * share * vec3(noise.value * weight,
                                        (noise.gradient * scale) * weight + noise.value * weight_slope);
        next_octave(cell, offset);
        scale = finer * scale;
        amplitude *= gain;
    }
    return sum;
}
