// right, in its pictures too
#include "11_fractals/noise_jet.glsl"
vec3 eroded_fbm(ivec2 cell, vec2 offset, float octaves, float erosion, float gain) {
    float height = 0.0, amplitude = 1.0;
    vec2 slope = vec2(0.0), d = vec2(0.0), d_by_x = vec2(0.0), d_by_y = vec2(0.0);
    mat2 scale = mat2(1.0);
    int k = 0;
    while (octaves > float(k) && k < 16) {
        settle(cell, offset);
        NoiseJet n = noise_jet(cell, offset);
        float share = octaves - float(k) < 1.0 ? octaves - float(k) : 1.0;
        mat2 by = n.hessian * scale;
        for (int i = 0; i < 2; ++i) {
            d[i] += share * n.gradient[i];
            d_by_x[i] += share * by[0][i];
            d_by_y[i] += share * by[1][i];
        }
        float below = 1.0 + erosion * dot(d, d);
        vec2 below_by = 2.0 * erosion * vec2(dot(d, d_by_x), dot(d, d_by_y));
        vec2 by_place = n.gradient * scale;
        for (int i = 0; i < 2; ++i)
            slope[i] += amplitude * share * (by_place[i] / below - n.value * below_by[i] / (below * below));
        height += amplitude * share * n.value / below;
        next_octave(cell, offset);
        scale = finer * scale;
        amplitude *= gain;
        ++k;
    }
    return vec3(height, slope);
}
