// How a fragment shader of surfaces ends. Of transparent ones whoever mixes them puts another file in place of this one: it
// declares its own outputs and has the same function.

layout(location = 0) out vec4 color;

// `radiance`: towards the eye, linear; of a transparent surface not multiplied by `alpha`, the share of what lies behind
// that it hides.
void put_surface(vec3 radiance, float alpha) {
    color = vec4(radiance, 1.0);
#ifdef TRANSPARENT
    color.a = alpha;
#endif
}
