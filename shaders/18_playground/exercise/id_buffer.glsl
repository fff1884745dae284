// Exercise 18.id_buffer: what is picked, from an image of numbers.
// As it stands the first item cannot be picked, and thin things only where the mouse is exactly on them.
#include "18_playground/ids.glsl"

// [id_buffer]
// Each pixel of an R32_UINT image holds a number for the item that is seen there, and 0 where there is none: the image is
// cleared to 0. Returns the number of item `item`, 0 to 2^32 - 2. (In floats numbers above 2^24 are rounded to their
// neighbours', in half floats those above 2,048.) item_of() is the way back; it is asked for numbers above 0 only.
uint id_of(uint item) {
    return item;
}

uint item_of(uint id) {
    return id;
}

// The number that a click on `pixel` picks. id_at(p) reads pixel p of the image, which must be inside: x from 0 to
// ids_size().x - 1, y from 0 to ids_size().y - 1. Nobody hits a wire exactly: so it is the nearest pixel with a number
// other than 0 whose distance from `pixel` is at most `reach` (the square of the distance at most reach * reach). Of
// several that are equally near, the one in the upper row, and in a row the left one. 0 where there is none. `pixel` itself
// may lie outside. Numbers are never averaged: between item 3 and item 5 there is no item 4.
uint id_near(ivec2 pixel, int reach) {
    return id_at(pixel);
}
// [/id_buffer]
