// Exercise 15.height_blend: which of four textures shows at a point, by their weights and heights.
// Starter: they fade into each other like fog.

// [height_blend]
// Four materials meet at a point. `weights` says how much of each is expected here; each weight
// is 0 or more, and their sum is 1. `heights` says how high the material's own surface stands
// at this point, 0 to 1: high on a stone, low in the gap between two stones, so that snow shows
// in the gaps first.
//
// The *rank* of a material is its weight plus its height. `top` is the greatest rank among the
// materials whose weight is above 0. A material of weight 0 is not there: it has no share, and
// its height must not push the others down. Any other material gets a share proportional to
// weight * (rank - top + softness) where that is above 0, and otherwise none. `softness` is
// above 0. Returns the shares, scaled so that their sum is 1.
// [/height_blend]
vec4 height_blend(vec4 weights, vec4 heights, float softness) {
    return weights;
}
