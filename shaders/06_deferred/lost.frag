// Encoding error of the G-buffer: surfaces encoded and decoded at once.
#include "06_deferred/mapped_pixel.glsl"
#include "06_deferred/gbuffer.glsl"
#include "06_deferred/position_from_depth.glsl"

layout(location = 0) out vec4 color;

layout(scalar) uniform ClipBlock { mat4 clip_to_offset; };

#if !GBUFFER_IS_PACKED
vec4 half_of(vec4 v) { return vec4(unpackHalf2x16(packHalf2x16(v.xy)), unpackHalf2x16(packHalf2x16(v.zw))); }
#endif

Pixel kept(Pixel p) {
    Stored s = store(p);
#if !GBUFFER_IS_PACKED
    s.normal = half_of(s.normal);
#endif
    Pixel back = restore(s);
#if GBUFFER_METHOD != GBUFFER_METHOD_FAT
    back.position = view.eye + position_from_depth(uvec2(gl_FragCoord.xy), gl_FragCoord.z, view.size, clip_to_offset);
#endif
    return back;
}

void main() {
    MappedSurface m = seen_surface();
    Pixel p = pixel_of(m), back = kept(p);
    // Angle from half the chord, its half's sine, since acos() of a dot product is inexact for small angles. Then
    // millimetres.
    vec2 lost = vec2(degrees(2.0 * asin(min(0.5 * distance(back.normal, p.normal), 1.0))), 1e3 * distance(back.position, p.position));
#if GBUFFER_METHOD == GBUFFER_METHOD_FORWARD
    lost = vec2(0.0);
#endif
    color = vec4(lost, 0.0, 1.0);
}
