// How much of the water is covered with foam.
uniform sampler2D foam_tile;

// [foam]
// `jacobian`: 1 at rest, below 0 where the surface folds. `depth_m`: of the water.
float foam_share(vec2 at, float jacobian, float depth_m, float spacing) {
    float folded = smoothstep(water_now.foam, water_now.foam - 0.5, jacobian);
    float shore = water_now.shore_m > 0.0 ? 1.0 - smoothstep(0.0, water_now.shore_m, depth_m) : 0.0;
    float amount = max(folded, 0.8 * shore);
    if (amount <= 0.0) return 0.0;
    float level = log2(max(spacing * water_now.foam_scale * float(textureSize(foam_tile, 0).x), 1.0));
    float bubbles = textureLod(foam_tile, at * water_now.foam_scale, level).r;
    // Little foam keeps the bubbles' borders alone; much fills them.
    return amount * smoothstep(1.0 - amount, 1.6 - amount, bubbles + 0.35);
}
// [/foam]
