// Exercise 04.parallax_occlusion: the hit of the camera ray, searched layer by layer and then refined.
// Starter: the ray stops where it enters.

float depth_at(vec2 uv);  // of the surface: 0 at the mesh, 1 at the deepest point

// [first_layer_below]
// The camera ray enters at `uv` with depth 0. At depth t it is above uv - t * shift, where
// the surface has the depth depth_at(uv - t * shift). The ray is below the surface where t
// is greater than or equal to that depth.
//
// Returns the first of the depths 0, 1/steps, 2/steps, ..., 1 at which the ray is below the
// surface. At depth 1 it always is. `steps` is 1 or more.
// [/first_layer_below]
float first_layer_below(vec2 uv, vec2 shift, int steps) {
    return 0.0;
}

// [parallax_occlusion]
// Returns the depth of the hit, refined between two layers. The ray meets the surface
// between the depth that first_layer_below() returns and the layer before it. Treat the
// surface as a straight line between its depths at these two layers, and return the depth
// at which the ray meets this line. If the ray is below the surface at depth 0 already, the
// result is 0.
// [/parallax_occlusion]
float parallax_occlusion(vec2 uv, vec2 shift, int steps) {
    return 0.0;
}
