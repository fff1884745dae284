// Exercise 11.terrain_mix: the amount of snow.
// Starter: there is no snow.

// [terrain_mix]
// Returns the fraction of snow, 0 to 1, at a point. normal_y is the vertical component
// of its normal: 1 on level ground, 0 at a wall. `roughness`, -1 to 1, is the height
// above the snow line with noise added, which breaks up the edge of the snow; `strength`
// scales it (1 in this chapter).
//
// Let begins = lower.x - lower.y * normal_y and ends = upper.x - upper.y * normal_y.
// Both are low on level ground and high on steep ground. The fraction rises as a
// smoothstep of strength * roughness, from 0 at begins to 1 at ends.
//
// The two lines may cross. If begins is not below ends, smoothstep is undefined in
// GLSL; the edge is then a hard one at begins: 1 where strength * roughness is at least
// begins, 0 elsewhere.
// [/terrain_mix]
float terrain_mix(float normal_y, float roughness, vec2 lower, vec2 upper, float strength) {
    return 0.0;
}
