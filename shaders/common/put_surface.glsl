// Output of surface shaders. Methods for transparency replace this file.

layout(location = 0) out vec4 color;
#ifdef TRANSPARENT
layout(location = 0, index = 1) out vec4 passed;  // share of the light behind, by channel: Blend::filtered
#endif

// `radiance`: linear, towards the camera, not premultiplied by the opacity `alpha`. `tint`: share of the light from behind
// that passes where alpha leaves any, by channel.
void put_surface(vec3 radiance, float alpha, vec3 tint) {
    color = vec4(radiance, 1.0);
#ifdef TRANSPARENT
    color.a = alpha;
    passed = vec4((1.0 - alpha) * tint, 0.0);
#endif
}
