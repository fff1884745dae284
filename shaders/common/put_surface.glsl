// Output of surfaces' fragment shaders. A method for transparent surfaces replaces this file by one with its own
// outputs.

layout(location = 0) out vec4 color;

// `radiance`: towards the camera, linear, not multiplied by `alpha`, the opacity.
void put_surface(vec3 radiance, float alpha) {
    color = vec4(radiance, 1.0);
#ifdef TRANSPARENT
    color.a = alpha;
#endif
}
