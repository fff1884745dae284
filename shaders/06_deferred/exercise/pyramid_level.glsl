// Exercise 06.pyramid_level: the level of a depth pyramid that answers for a rectangle.
// Starter: a level so small that hardly anything is hidden behind its one texel.

// [pyramid_level]
// low and high are the first and the last pixel of a rectangle, 0 <= low <= high < 65536. In
// level k of the pyramid pixel p lies in texel p >> k: level 0 has a texel for each pixel.
// Returns the smallest level in which the rectangle lies in at most two texels along x and in
// at most two along y, so that four reads cover it. A larger level would hide less, since
// its texels see more of the far surfaces around.
// [/pyramid_level]
int pyramid_level(ivec2 low, ivec2 high) {
    return 16;
}
