// Solution of 05.penumbra_width (R. Fernando, "Percentage-Closer Soft Shadows", SIGGRAPH 2005 sketches).

float penumbra_width(float receiver, float blocker, float size, bool parallel) {
    float gap = max(receiver - blocker, 0.0);
    return parallel ? size * gap : size * gap / max(blocker, 1e-3);  // similar triangles, or one angle for all
}
