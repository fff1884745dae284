// Exercise 06.position_from_depth: the world-space position of the surface in a pixel.
// Starter: all of it is in one place.

// [position_from_depth]
// The world-space position of the surface that a pixel shows. The centre of the pixel is at
// pixel + 0.5, in a picture of `size` pixels whose first pixel is at the upper left. In
// clip space, after the division by w, x and y run from -1 to 1, x to the right and y down,
// as pixel rows do; z is the value in the depth buffer, from 1 near to 0 far, without any
// change. `clip_to_world` is the inverse of the matrix from world space to clip space; it
// gives homogeneous coordinates. `depth` is above 0.
// [/position_from_depth]
vec3 position_from_depth(uvec2 pixel, float depth, vec2 size, mat4 clip_to_world) {
    return vec3(0.0);
}
