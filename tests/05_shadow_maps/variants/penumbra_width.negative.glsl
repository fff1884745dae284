// wrong: expected 0
float penumbra_width(float receiver, float blocker, float size, bool parallel) {
    float gap = receiver - blocker;
    return parallel ? size * gap : size * gap / max(blocker, 1e-3);
}
