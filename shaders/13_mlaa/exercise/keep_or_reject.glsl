// Exercise 13.keep_or_reject: whether the history of a pixel is that of its surface.
// Starter: all history is kept, and leaves ghosts.

// [keep_or_reject]
// The surface in a pixel was at `at` in the frame before, in pixels; that picture reached
// from (0, 0) to `size`. If it was visible there, its inverse distance was `expected`, in
// 1/m: 0 at infinity, larger is nearer. `farthest` is the smallest inverse distance that
// the frame before saw in the 3x3 pixels around `at`.
//
// Returns whether the history there may be used. Reject it
// - where `at` lies outside of the picture: below 0, or at `size` and beyond it;
// - where something else hid the surface: even the farthest of the nine pixels was nearer
//   than expected, by more than 5% of `expected` plus 1e-6 per metre for rounding.
// Keep it everywhere else. That the nine pixels were farther than expected says nothing: the
// samples of that frame may all have missed a wire.
// [/keep_or_reject]
bool keep_history(vec2 at, vec2 size, float expected, float farthest) {
    return true;
}
