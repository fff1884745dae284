// Solution of 14.bent_cone. C. Oat and P. V. Sander, "Ambient aperture lighting", I3D 2007.
float lobe_in_cone(float cone_rad, float lobe_rad, float between_rad) {
    float wider = max(cone_rad, lobe_rad), narrower = min(cone_rad, lobe_rad);
    if (between_rad >= cone_rad + lobe_rad) return 0.0;
    float common_part = 1.0 - cos(narrower);
    if (between_rad > wider - narrower) {
        float share = 1.0 - (between_rad - (wider - narrower)) / (2.0 * narrower);
        common_part *= smoothstep(0.0, 1.0, share);
    }
    return clamp(common_part / max(1.0 - cos(lobe_rad), 1e-6), 0.0, 1.0);
}
