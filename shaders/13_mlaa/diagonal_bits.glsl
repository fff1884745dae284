// A step of a staircase: the edge below a pixel, and the edge across that goes on downwards from its end, on the right
// ("falling") or on the left ("rising"). For how many steps the staircase goes on, in the bytes of a word: falling back (up
// and left) and ahead (down and right), rising back (up and right) and ahead (down and left).
const uint back_falling = 0u, ahead_falling = 8u, back_rising = 16u, ahead_rising = 24u;
