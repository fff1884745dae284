// Exercise 04.parallax_occlusion: walk along the eye's ray until it is below the surface, then look closer.
// Until you fill it in, the ray stops where it enters.

float depth_at(vec2 uv);  // of the surface: 0 at the mesh, 1 at the deepest point

// [first_layer_below]
// The ray enters at `uv` with depth 0. When it is at depth t it is above uv - t * shift, where the surface's depth is
// depth_at(uv - t * shift). It is below the surface where t is not less than that.
//
// The first of the depths 0, 1/steps, 2/steps, ..., 1 at which the ray is below the surface. At 1 it always is. `steps`
// is 1 or more.
// [/first_layer_below]
float first_layer_below(vec2 uv, vec2 shift, int steps) {
    return 0.0;
}

// [parallax_occlusion]
// Between that layer and the one before, the ray has met the surface. Take the surface for a straight line there and
// return the depth at which the ray meets the line. Where the very first layer is below already, that is 0.
// [/parallax_occlusion]
float parallax_occlusion(vec2 uv, vec2 shift, int steps) {
    return 0.0;
}
