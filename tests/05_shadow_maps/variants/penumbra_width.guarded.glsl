// right
float penumbra_width(float receiver, float blocker, float size, bool parallel) {
    if (blocker >= receiver) return 0.0;
    if (parallel) return size * (receiver - blocker);
    return (receiver - blocker) * size / max(blocker, 0.001);
}
