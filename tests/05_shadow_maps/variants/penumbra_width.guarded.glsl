// right, in its pictures too
float penumbra_width(float receiver, float blocker, float size, bool parallel) {
    if (blocker >= receiver) return 0.0;
    if (parallel) return size * (receiver - blocker);
    float d = blocker < 0.001 ? 0.001 : blocker;
    return receiver > d ? (receiver - d) * size / d : 0.0;
}
