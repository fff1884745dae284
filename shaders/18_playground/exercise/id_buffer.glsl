// Exercise 18.id_buffer: what is picked, from an image of numbers.
// Starter: the first item cannot be picked, and thin things only where the mouse is exactly on them.
#include "18_playground/ids.glsl"

// [id_buffer]
// Each pixel of an R32_UINT image holds the number of the item that is seen there, or 0 if
// there is none: the image is cleared to 0. id_of() returns the number of `item`, which is 0 to
// 2^32 - 2. item_of() is its inverse, and is called with numbers above 0 only. (Floats would
// not do. They round numbers above 2^24 to a neighbouring item's, half floats those above
// 2,048.)
uint id_of(uint item) {
    return item;
}

uint item_of(uint id) {
    return id;
}

// The number that a click on `pixel` picks. Nobody hits a wire exactly. The click therefore
// picks the nearest pixel that has a number other than 0, if its distance from `pixel` is at
// most `reach` pixels (the square of the distance at most reach * reach; `reach` is 0 or more).
// Of several that are equally near, it picks the one in the upper row, and within a row the
// left one. Returns 0 if there is none. Numbers are never averaged: between item 3 and item 5
// there is no item 4.
//
// id_at(p) reads pixel p of the image. p must be inside: x from 0 to ids_size().x - 1, y from 0
// (the top row) to ids_size().y - 1. `pixel` itself may lie outside.
uint id_near(ivec2 pixel, int reach) {
    return id_at(pixel);
}
// [/id_buffer]
