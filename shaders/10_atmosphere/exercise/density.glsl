// Exercise 10.density: the densities of the air at a height.
// Starter: there is no air.

// [density]
// Returns three relative densities at `height`; heights and widths are in metres.
// Rounding may give a height below 0: use the three densities at the ground there.
// - x: molecules, exp(-height / rayleigh_height). y: dust, exp(-height / mie_height).
//   Both are 1 at the ground. A scale height of 0 means that there are no such
//   particles: 0 everywhere.
// - z: a layer whose density is 1 at the height layer_center and falls linearly to 0 at
//   layer_width above and below it. Beyond, it stays 0. A layer_width of 0 means that
//   there is no layer: 0 everywhere.
// [/density]
vec3 density(float height, float rayleigh_height, float mie_height, float layer_center, float layer_width) {
    return vec3(0.0);
}
