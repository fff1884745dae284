// Solution of 04.parallax_occlusion.

float depth_at(vec2 uv);  // of the surface: 0 at the mesh, 1 at the deepest point

// M. McGuire and M. McGuire, "Steep Parallax Mapping", I3D 2005 poster.
float first_layer_below(vec2 uv, vec2 shift, int steps) {
    for (int i = 0; i < steps; ++i) {
        float t = float(i) / float(steps);
        if (t >= depth_at(uv - t * shift)) return t;
    }
    return 1.0;
}

// Z. Brawley and N. Tatarchuk, "Parallax Occlusion Mapping", ShaderX3, 2004: the secant of the last step.
float parallax_occlusion(vec2 uv, vec2 shift, int steps) {
    float below = first_layer_below(uv, shift, steps);
    if (below <= 0.0) return 0.0;
    float above = below - 1.0 / float(steps);
    float gap = depth_at(uv - above * shift) - above;    // surface below the ray, above 0
    float overlap = below - depth_at(uv - below * shift);  // ray below the surface, 0 or more
    return mix(above, below, gap / max(gap + overlap, 1e-6));
}
