// Exercise 17.flow_blend: a moving picture of clouds from two still ones.
// As it stands the first one stands still until the second takes its place.

// [flow_blend]
// Two pictures of the same clouds, A at the beginning and B at the end of an interval; `t` is the time within it, 0 to 1.
// `shift` is how far the wind carries the clouds at this place during the whole interval, in the unit of `uv`. What is at
// uv now was further up the wind when A was taken, and will be further down when B is. Returns where to read A (x, y) and
// where to read B (z, w). Where the wind is right both show the same cloud at all times.
vec4 flow_places(vec2 uv, vec2 shift, float t) {
    return vec4(uv, uv);
}

// The share of B in the picture: 0 at the beginning, where A is read unmoved, 1 at the end, where B is, evenly between. So
// the next interval, whose A is this one's B, goes on without a jump.
float flow_weight(float t) {
    return floor(t);
}
// [/flow_blend]
