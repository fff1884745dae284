// Output of surface shaders. Methods for transparency replace this file.

layout(location = 0) out vec4 color;

// `radiance`: linear, towards the camera, not premultiplied by the opacity `alpha`.
void put_surface(vec3 radiance, float alpha) {
    color = vec4(radiance, 1.0);
#ifdef TRANSPARENT
    color.a = alpha;
#endif
}
