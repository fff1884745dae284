// Exercise 10.height_fog: the optical depth of fog that gets thinner with height.
// Starter: the fog is as dense everywhere as at the camera.

// [height_fog]
// Returns the optical depth of the fog between the camera and a point. The density at
// the height h is density * exp(-falloff * h), in 1/m. The camera is at the height `y`
// (metres); `slope` (-1 to 1) is the vertical component of the direction to the point,
// and `distance` (metres) its distance. density and falloff (1/m) are 0 or more.
//
// The integral along the path has a closed form: with x = falloff * slope * distance it
// is
//
//     density * exp(-falloff * y) * distance * (1 - exp(-x)) / x
//
// Three things go wrong with it in floats.
// - x is 0 for a level path and for uniform fog (falloff 0).
// - For a small x, 1 - exp(-x) has hardly any digits left: at 1e-6 it is wrong by 1%.
// - For a path far downwards exp(-x) overflows, although the fog at its lower end is
//   finite. Start from the lower end of the path instead.
//
// The result must be within a factor of 1 +- 3e-5 of the exact value, as long as
// -falloff * height is below 80 at both ends.
// [/height_fog]
float height_fog(float density, float falloff, float y, float slope, float distance) {
    return density * exp(-falloff * y) * distance;
}
