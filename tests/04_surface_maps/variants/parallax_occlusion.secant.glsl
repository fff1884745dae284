// right, in its pictures too

float depth_at(vec2 uv);

float first_layer_below(vec2 uv, vec2 shift, int steps) {
    for (int i = 0; i <= steps; ++i) {
        float t = float(i) / float(steps);
        if (i == steps || depth_at(uv - t * shift) <= t) return t;
    }
    return 1.0;
}

float parallax_occlusion(vec2 uv, vec2 shift, int steps) {
    float below = first_layer_below(uv, shift, steps);
    if (below == 0.0) return 0.0;
    float size = 1.0 / float(steps), above = below - size;
    float gap = depth_at(uv - above * shift) - above, overlap = below - depth_at(uv - below * shift);
    return above + size * gap / (gap + overlap);
}
