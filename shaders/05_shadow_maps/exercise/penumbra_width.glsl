// Exercise 05.penumbra_width: the width of a soft shadow edge.
// Starter: every shadow is as hard as the map's texels.

// [penumbra_width]
// The width, in metres, of the penumbra that an edge `blocker` metres from the light casts
// on a surface `receiver` metres from it, both measured along the view of the light. `size`
// is the diameter of the light in metres and may be 0. A directional light (`parallel`) is
// infinitely far away: then `size` is 2 tan(half its angular diameter), and both distances
// are measured from the map's near plane. A blocker that is not nearer than the receiver
// casts no shadow: the width is 0. Unless `parallel`, a blocker nearer than 1 mm counts as
// 1 mm away, also when its distance to the receiver is taken.
// [/penumbra_width]
float penumbra_width(float receiver, float blocker, float size, bool parallel) {
    return 0.0;
}
