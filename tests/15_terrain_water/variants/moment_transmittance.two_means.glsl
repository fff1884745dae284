// wrong: moment_transmittance(
// The mean and the variance alone: mass at z and at one other depth, Chebyshev's bound.
float moment_transmittance(vec4 b, float all, float z, float overestimation) {
    float variance = max(b.y - b.x * b.x, 1e-7), away = z - b.x;
    float at_z = variance / (variance + away * away), other = away > 0.0 ? 1.0 - at_z : 0.0;
    return exp(-all * (other + overestimation * at_z));
}
