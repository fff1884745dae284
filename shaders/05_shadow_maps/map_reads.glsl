// Reading a layer of the map of depths, and the surface that is compared with it.

#ifdef FIELD
// For checks: maps whose depths are known.
const int field_texels = 64;
int texels_read = 0, texels_gathered = 0;

int map_texels() { return field_texels; }

float field_depth(ivec2 texel) {
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(field_texels)))) return 0.0;
#if FIELD == 1
    return texel.x < 32 ? 0.75 : 0.25;                                             // an edge along v
#elif FIELD == 2
    return 0.5 + 0.3 * ((float(texel.x) + 0.5) / 64.0 - 0.5) - 0.2 * ((float(texel.y) + 0.5) / 64.0 - 0.5);  // a plane
#else
    return (texel.x * 7 + texel.y * 13) % 5 < 2 ? 0.75 : 0.25;                      // single texels
#endif
}

float read_depth(vec2 uv, uint layer) {
    ++texels_read;
    return field_depth(ivec2(floor(uv * float(field_texels))));
}

vec4 gather_depths(vec2 uv, uint layer) {
    texels_gathered += 4;
    ivec2 at = ivec2(floor(uv * float(field_texels) - 0.5));
    return vec4(field_depth(at + ivec2(0, 1)), field_depth(at + 1), field_depth(at + ivec2(1, 0)), field_depth(at));
}
#else
uniform sampler2DArray shadow_map;  // outside of it: 0, nothing is nearer to the light

int map_texels() { return textureSize(shadow_map, 0).x; }

// The depth of the texel that holds this place.
float read_depth(vec2 uv, uint layer) { return textureLod(shadow_map, vec3(uv, layer), 0.0).r; }

// The depths of the four texels that meet in the corner nearest to uv: x lower left, y lower right, z upper right, w upper
// left, where lower is the greater v.
vec4 gather_depths(vec2 uv, uint layer) { return textureGather(shadow_map, vec3(uv, layer), 0); }
#endif

// [receiver_struct]
// A point as a map sees it.
struct Receiver {
    vec3 place;  // as light_clip_position says
    vec2 slope;  // by how much depth changes on the surface, over the map's width along u and along v; 0: not asked for
};
// [/receiver_struct]

// The surface's own depth at a place of the map. Where its plane lies beyond the far one it is 0, as what the map holds
// there: nothing is in the way.
float plane_depth(Receiver r, vec2 uv) { return max(r.place.z + dot(r.slope, uv - r.place.xy), 0.0); }

// [plane_depths]
// The same in the middle of those four texels, for a corner at uv.
vec4 plane_depths(Receiver r, vec2 corner) {
    vec2 half_texel = r.slope * (0.5 / float(map_texels()));
    float middle = r.place.z + dot(r.slope, corner - r.place.xy);
    return max(middle + vec4(half_texel.y - half_texel.x, half_texel.x + half_texel.y, half_texel.x - half_texel.y,
                             -half_texel.x - half_texel.y), 0.0);
}
// [/plane_depths]
