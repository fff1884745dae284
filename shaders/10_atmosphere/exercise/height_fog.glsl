// Exercise 10.height_fog: how much fog lies on the way, where fog gets thinner with height.
// Until you fill it in, it is as thick everywhere as at the eye.

// [height_fog]
// The optical depth of the way from the eye to a point: the integral of the fog's density along it. The density at the
// height y is density * exp(-falloff * y), in 1/m; `y` is the eye's height in metres, `slope` the y of the way's direction
// (-1 to 1), `distance` its length in metres. density and falloff (1/m) are 0 or more. The integral has a closed form, which
// holds (1 - exp(-x)) / x with x = falloff * slope * distance. Three things go wrong with it in floats: x is 0 for a level
// way and for uniform fog; for a small x, 1 - exp(-x) has hardly a digit left (at 1e-6 it is off by 1%); and a way that
// leads far down has exp(-x) overflow though the fog at its lower end is finite. Within 3e-5 of the exact value everywhere,
// as long as -falloff * y is below 80 at both ends.
// [/height_fog]
float height_fog(float density, float falloff, float y, float slope, float distance) {
    return density * exp(-falloff * y) * distance;
}
