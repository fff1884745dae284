// Exercise 10.density: how much of the air there is at a height.
// Until you fill it in, there is none.

// [density]
// x, y: of molecules and of dust, relative to the ground: they fall by a factor of e with each scale height. Below the
// ground (a height below 0, from rounding) it is the ground's. A scale height of 0 says that there are no such particles: 0
// everywhere. z: of a layer that is 1 at the height layer_center and falls linearly to 0 at layer_width below and above it,
// and stays 0 from there on; a layer_width of 0 says that there is no layer. Heights in metres.
// [/density]
vec3 density(float height, float rayleigh_height, float mie_height, float layer_center, float layer_width) {
    return vec3(0.0);
}
