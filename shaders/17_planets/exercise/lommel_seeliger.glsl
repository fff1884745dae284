// Exercise 17.lommel_seeliger: the light of dark dust, by depth.
// Starter: Lambert's law, and the Moon looks like a ball of plaster.

// [lommel_seeliger]
// Dust is deep and so dark that light which is scattered twice is lost. `mu0` is the cosine of
// the angle between the normal and the direction to the sun, `mu` that to the camera, both -1 to
// 1. At the optical depth t, measured straight down, exp(-t / mu0) of the sunlight is left. The
// camera's ray is dt / mu long between the depths t and t + dt, and sees light in proportion to
// that length and to the sunlight left there. Every grain scatters evenly, in all directions. Of
// what the grains scatter, exp(-t / mu) comes out.
//
// Returns the sum over all depths, from 0 on, divided by what it is with the sun and the camera
// overhead, mu0 = mu = 1. Where the sun is at the horizon or below it, mu0 <= 0, it is 0. A
// camera below the horizon, which only an interpolated normal can have, sees what one at mu = 0
// does: the limit of the sum. Tolerance: 1e-4.
// [/lommel_seeliger]
float lommel_seeliger(float mu0, float mu) {
    return max(mu0, 0.0);
}
