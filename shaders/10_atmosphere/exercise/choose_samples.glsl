// Exercise 10.choose_samples: choose and defend: how to sum up densities on three paths.
// Starter: every path is exact, and costs too much.

// [choose_samples]
// The optical depth of the molecules (scale height 8 km, planet's radius 6,360 km) is summed up
// from a few densities. `path` is one of three:
// - 0: from sea level straight up to 100 km;
// - 1: from 20 km down to 5 km, where it is level, and up to 20 km again, 874 km in all;
// - 2: from sea level over 20 km, rising by 1 m in 20.
//
// Returns the method and its number n, 1 to 64. Methods:
// - 1: middles of n equal parts, n densities;
// - 2: trapezium rule, the ends of n equal parts, n + 1 densities;
// - 3: middles of n parts that grow: part i ends at ((i + 1) / n)^2 of the length, n densities.
//
// Limits: path 0 may cost 16 densities and err by 1%, path 1 4 densities and 1.25%, path 2 1
// density and 0.1%. The check measures both and prints them.
// [/choose_samples]
ivec2 choose_samples(int path) {
    return ivec2(1, 64);
}
