// Exercise 17.flow_blend: a moving picture of clouds from two still ones.
// Starter: the first one stands still until the second replaces it.

// [flow_blend]
// Two pictures of the same clouds, A at the beginning and B at the end of an interval; `t` is
// the time within it, 0 to 1. `shift` is how far the wind carries the clouds at this point
// during the whole interval, in the unit of `uv`. The cloud that is at uv now was farther
// upwind when A was taken, and will be farther downwind when B is taken. Returns the positions of
// this cloud in A (x, y) and in B (z, w), in this order.
vec4 flow_places(vec2 uv, vec2 shift, float t) {
    return vec4(uv, uv);
}

// Returns the weight of B in the picture; A has the rest. It grows linearly from 0 at the
// beginning of the interval, where A is read at uv itself, to 1 at the end, where B is. So the
// next interval, whose A is this one's B, goes on without a jump.
float flow_weight(float t) {
    return floor(t);
}
// [/flow_blend]
