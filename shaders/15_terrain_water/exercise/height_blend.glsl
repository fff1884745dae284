// Exercise 15.height_blend: which of four textures shows at a place, by their weights and heights.
// Until you fill it in, they fade into each other like fog.

// [height_blend]
// Four materials meet at a place: `weights` (each 0 or more, their sum is 1) says how much of each is expected here, `heights`
// (0 to 1) how high its own surface stands at this place: a stone, the gap between two stones. Snow fills the gaps
// first. The *rank* of a material is its weight plus its height; `top` is the greatest rank among those whose weight is above
// 0. A material within `softness` (above 0) of the top gets a share in proportion to weight * (rank - top + softness), any
// other none. Returns the shares, scaled so that their sum is 1. A material of weight 0 is not there: it has no share, and
// its height must not push the others down.
// [/height_blend]
vec4 height_blend(vec4 weights, vec4 heights, float softness) {
    return weights;
}
