// Exercise 14.direction_to_equirect: where a direction lies in a picture of all directions.
// Starter: every direction is the picture's middle, and the environment has one colour.

// [direction_to_equirect]
// The position in an equirectangular picture, 0 to 1 in u (from the left) and v (from
// above). The picture's middle is -z, a quarter to the right of it is +x, its left and
// right edges meet at +z; its upper edge is +y, its lower edge -y. There, u is linear in
// the angle around +y, and v is linear in the angle from +y. `direction` has any length
// above 0. Directions with x = 0 and z above 0 lie on both edges: u is 0 or 1, and either
// is right. Straight up and straight down any u is right as long as it is a number:
// choose 1/2, and note that atan(0.0, 0.0) is undefined in GLSL.
// [/direction_to_equirect]
vec2 direction_to_equirect(vec3 direction) {
    return vec2(0.5);
}
