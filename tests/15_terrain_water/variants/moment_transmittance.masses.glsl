// right, in its pictures too
// About the mean: eliminated by hand, and what lies at each depth by Lagrange's form.
float share(vec4 b, float at, float other, float third) {
    return (b.y - (other + third) * b.x + other * third) / ((at - other) * (at - third));
}

float moment_transmittance(vec4 b, float all, float z, float overestimation) {
    float variance = b.y - b.x * b.x, skew = b.z - b.x * b.y, slope = skew / variance;
    float rest = b.w - b.y * b.y - skew * slope;
    float q2 = (z * z - b.y - slope * (z - b.x)) / rest;
    float q1 = (z - b.x) / variance - slope * q2;
    float q0 = 1.0 - b.x * q1 - b.y * q2;
    float root = sqrt(max(q1 * q1 - 4.0 * q2 * q0, 0.0));
    float t1 = (-q1 - root) / (2.0 * q2), t2 = (-q1 + root) / (2.0 * q2), before = overestimation * share(b, z, t1, t2);
    if (t1 < z) before += share(b, t1, z, t2);
    if (t2 < z) before += share(b, t2, z, t1);
    return exp(-all * before);
}
