// What a box may cover of a picture.
struct ScreenBox {
    vec2 low, high;  // pixels; the picture is 0 to its size
    float nearest;   // depth of its nearest point: 1 at the near plane, 0 at the far one
};
