// Exercise 06.position_from_depth: where is the surface that a pixel shows?
// Until you fill it in, all of it is in one place.

// [position_from_depth]
// The middle of the pixel is at pixel + 0.5, of a picture of `size` pixels whose first pixel is at the upper left. In
// clip space x and y go from -1 to 1, x to the right and y down, as rows do; z is what the depth buffer holds, from 1
// near to 0 far, as it stands. `clip_to_world` is the inverse of the matrix that took the surface there. What it gives
// is homogeneous. `depth` is above 0.
// [/position_from_depth]
vec3 position_from_depth(uvec2 pixel, float depth, vec2 size, mat4 clip_to_world) {
    return vec3(0.0);
}
