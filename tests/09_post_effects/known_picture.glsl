// For checks of 09.radial_blur and 09.sharpen: a picture of which every place is known.
#pragma replaces "09_post_effects/picture_source.glsl"

const ivec2 check_known_size = ivec2(5, 4);
ivec2 picture_size() { return check_known_size; }
vec3 texel(ivec2 at) {
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, check_known_size))) return vec3(-1e6);
    return vec3(1.0 + float(at.x) + 10.0 * float(at.y), float(at.x * at.x), at == ivec2(2, 1) ? 1.0 : 0.0);
}
vec3 picture(vec2 uv) { return vec3(uv, uv.x * uv.x + uv.y); }
