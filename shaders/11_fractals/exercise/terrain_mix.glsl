// Exercise 11.terrain_mix: where snow lies.
// Until you fill it in, it lies nowhere.

// [terrain_mix]
// The share of snow, 0 to 1, at a point whose normal has the height `normal_y` (1: level ground, 0: a wall). `roughness`
// is a noise, -1 to 1, that breaks the edge up. Snow begins where strength * roughness reaches lower.x - lower.y * normal_y
// and is whole where it reaches upper.x - upper.y * normal_y, with smoothstep between the two: on level ground both are
// low, on steep ground high. They are lines over normal_y, and may cross: where the first is not below the second, which
// smoothstep leaves open, the edge is a hard one, at the first: 1 from there on, 0 before.
// [/terrain_mix]
float terrain_mix(float normal_y, float roughness, vec2 lower, vec2 upper, float strength) {
    return 0.0;
}
