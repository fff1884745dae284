// Maps of bodies, as map_uv() has them, with no seam and no pinch.
#include "10_atmosphere/map_uv.glsl"

// [map_texel]
// The level follows from `footprint_rad`, the angle at the body's centre that a pixel covers. Derivatives fail: neighbours'
// coordinates differ by 1 across the date line and by anything at the poles, as if a pixel covered the whole map. Rows
// repeat around the body. Columns end at the poles; no place is read nearer to them than half a texel of its level.
vec4 map_texel(sampler2D map, vec2 uv, float footprint_rad) {
    float rows = float(textureSize(map, 0).y), lod = max(log2(max(footprint_rad * rows / 3.14159265, 1e-6)), 0.0);
    float edge = min(0.5 * exp2(ceil(lod)) / rows, 0.5);
    return textureLod(map, vec2(uv.x, clamp(uv.y, edge, 1.0 - edge)), lod);
}
// [/map_texel]

// Angle at the body's centre of a pixel's share of its surface, seen at a cosine `mu`: `pixel_m` wide across the ray, as much
// longer along it as the surface slants. Between the two lies the root of their product; at the limb it has an end.
float footprint_of(float pixel_m, float radius_m, float mu) { return pixel_m / (radius_m * sqrt(max(mu, 0.04))); }
