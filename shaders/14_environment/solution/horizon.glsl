// Solution of 14.horizon.
float raised_horizon(float horizon, float found, float away_m, float radius_m, float thickness) {
    float share = clamp(away_m / radius_m, 0.0, 1.0);
    found = mix(found, -1.0, share * share);
    return found > horizon ? found : mix(horizon, found, thickness);
}
