// wrong: blocker = 0
float penumbra_width(float receiver, float blocker, float size, bool parallel) {
    float gap = max(receiver - blocker, 0.0);
    return parallel ? size * gap : size * gap / max(blocker, 1e-3);
}
