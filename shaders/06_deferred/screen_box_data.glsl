// Screen-space bounds of a box.
struct ScreenBox {
    vec2 low, high;  // pixels, 0 to the picture's size
    float nearest;   // depth of the nearest point: 1 at the near plane, 0 at the far plane
};
