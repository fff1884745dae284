// Exercise 05.penumbra_width: how soft an edge of shadow is.
// Until you fill it in, every shadow is as hard as the map's texels.

// [penumbra_width]
// The width in metres of the half shadow that an edge `blocker` metres away from the lamp throws on a surface `receiver`
// metres away from it, both along the view. `size` is the diameter of the lamp, in metres, and may be 0. A directional
// light (`parallel`) is endlessly far away: there `size` is 2 tan of half the angle that it fills, and both distances are
// from the map's near plane. A blocker that is not nearer than the receiver throws no shadow. Unless `parallel`, one nearer
// than 1 mm counts as 1 mm away, in the gap too.
// [/penumbra_width]
float penumbra_width(float receiver, float blocker, float size, bool parallel) {
    return 0.0;
}
