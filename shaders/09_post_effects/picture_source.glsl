// For 09.radial_blur and 09.sharpen: the picture that they read.
#ifdef KNOWN_PICTURE
// For checks: a picture of which every place is known.
const ivec2 known_size = ivec2(5, 4);
ivec2 picture_size() { return known_size; }
vec3 texel(ivec2 at) {
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, known_size))) return vec3(-1e6);
    return vec3(1.0 + float(at.x) + 10.0 * float(at.y), float(at.x * at.x), at == ivec2(2, 1) ? 1.0 : 0.0);
}
vec3 picture(vec2 uv) { return vec3(uv, uv.x * uv.x + uv.y); }
#else
uniform sampler2D from;
ivec2 picture_size() { return textureSize(from, 0); }
vec3 texel(ivec2 at) { return texelFetch(from, at, 0).rgb; }
vec3 picture(vec2 uv) { return textureLod(from, uv, 0.0).rgb; }
#endif
