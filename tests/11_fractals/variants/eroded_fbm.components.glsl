// right, in its pictures too
#include "11_fractals/noise_jet.glsl"
vec3 eroded_fbm(ivec2 cell, vec2 offset, float octaves, float erosion, float gain) {
    float dx = 0.0, dy = 0.0;
    float dxx = 0.0, dxy = 0.0, dyx = 0.0, dyy = 0.0;
    mat2 scale = mat2(1.0);
    float height = 0.0, hx = 0.0, hy = 0.0, a = 1.0;
    for (int k = 0; k < 16; ++k) {
        if (float(k) >= octaves) break;
        settle(cell, offset);
        NoiseJet n = noise_jet(cell, offset);
        float share = min(octaves - float(k), 1.0);
        dx += share * n.gradient.x;
        dy += share * n.gradient.y;
        mat2 h = n.hessian * scale;
        dxx += share * h[0].x; dxy += share * h[1].x;
        dyx += share * h[0].y; dyy += share * h[1].y;
        float w = 1.0 / (1.0 + erosion * (dx * dx + dy * dy));
        float wx = -2.0 * erosion * w * w * (dx * dxx + dy * dyx);
        float wy = -2.0 * erosion * w * w * (dx * dxy + dy * dyy);
        vec2 g = n.gradient * scale;
        height += a * share * n.value * w;
        hx += a * share * (g.x * w + n.value * wx);
        hy += a * share * (g.y * w + n.value * wy);
        next_octave(cell, offset);
        scale = finer * scale;
        a *= gain;
    }
    return vec3(height, hx, hy);
}
