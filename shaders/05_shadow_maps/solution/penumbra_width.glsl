// Solution of 05.penumbra_width (R. Fernando, "Percentage-Closer Soft Shadows", SIGGRAPH 2005 sketches).

float penumbra_width(float receiver, float blocker, float size, bool parallel) {
    if (!parallel) blocker = max(blocker, 1e-3);
    float gap = max(receiver - blocker, 0.0);
    return parallel ? size * gap : size * gap / blocker;  // one angle for all, or similar triangles
}
