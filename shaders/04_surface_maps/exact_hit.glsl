// Where a ray meets the bilinear surface, exactly: from one square of four texel middles to the next.
#include "04_surface_maps/height_field.glsl"

#ifndef FIELD
// [exact_hit]
const int most_squares = 8192;

// The map repeats. (% is not defined for negative numbers.)
float texel_depth(ivec2 at, ivec2 size) {
    return 1.0 - texelFetch(height_map, at - size * ivec2(floor(vec2(at) / vec2(size))), 0).r;
}

// The smallest root of a r^2 + b r + c in [0, most], where c is above 0; -1 where there is none.
float first_root(float a, float b, float c, float most) {
    float discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return -1.0;
    float q = -0.5 * (b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
    float one = q != 0.0 ? c / q : -1.0, two = a != 0.0 ? q / a : -1.0;
    float root = one < 0.0 ? two : two < 0.0 ? one : min(one, two);
    return root <= most ? root : -1.0;
}

// The depth t at which the ray over uv - t * shift meets the surface. In a square the surface's depth is bilinear in
// x and y, which are linear in t: the gap between ray and surface is a quadratic polynomial of t.
float exact_hit(vec2 uv, vec2 shift) {
    ivec2 size = textureSize(height_map, 0);
    vec2 start = image_uv(fract(uv)) * vec2(size) - 0.5;  // in texels; texel middles are whole numbers
    vec2 along = vec2(-shift.x, shift.y) * vec2(size);    // for t from 0 to 1
    ivec2 square = ivec2(floor(start)), next = ivec2(sign(along));
    vec2 pace = 1.0 / max(abs(along), vec2(1e-9));  // t from one border to the next
    vec2 inside = start - vec2(square);
    vec2 border = mix(inside, 1.0 - inside, greaterThan(along, vec2(0.0))) * pace;  // t at which each is crossed
    float t = 0.0;
    for (int i = 0; i < most_squares; ++i) {
        float end = min(min(border.x, border.y), 1.0);
        float d00 = texel_depth(square, size), d10 = texel_depth(square + ivec2(1, 0), size);
        float d01 = texel_depth(square + ivec2(0, 1), size), d11 = texel_depth(square + ivec2(1, 1), size);
        vec2 slope = vec2(d10 - d00, d01 - d00);
        float twist = d00 - d10 - d01 + d11;
        vec2 p = start + t * along - vec2(square);
        float gap = d00 + dot(slope, p) + twist * p.x * p.y - t;
        if (gap <= 0.0) return t;
        float change = dot(slope, along) + twist * (p.x * along.y + p.y * along.x) - 1.0;
        float root = first_root(twist * along.x * along.y, change, gap, end - t);
        if (root >= 0.0) return t + root;
        if (end >= 1.0) return 1.0;
        t = end;
        bool across = border.x < border.y;
        square += across ? ivec2(next.x, 0) : ivec2(0, next.y);
        border += across ? vec2(pace.x, 0.0) : vec2(0.0, pace.y);
    }
    return 1.0;
}
// [/exact_hit]
#endif
