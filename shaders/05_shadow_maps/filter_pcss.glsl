// Percentage-closer soft shadows: blocker search, penumbra estimate, filter of that width.
#include "05_shadow_maps/penumbra_width.glsl"

// Vogel's spiral: points evenly spread over the unit disc ("A Better Way to Construct the Sunflower Head", 1979).
vec2 disc_point(int i, int count, float turn) {
    float angle = 2.39996323 * float(i) + turn;
    return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}

// Rotation of the disc per quarter texel: noise instead of rings. Hashed from integers, since the last bits of uv
// differ between devices.
float disc_turn(vec2 uv) {
    uvec2 cell = uvec2(max(4.0 * float(map_texels()) * uv, 0.0));
    uint hash = (cell.x * 0x9e3779b9u) ^ (cell.y * 0x85ebca6bu);
    hash = (hash ^ (hash >> 15)) * 0x2c1b3c6du;
    return 6.2831853 * float(hash >> 8) / 16777216.0;
}

// Map widths per metre at the point.
float map_widths_per_metre(ShadowView view, float distance) {
    return 1.0 / (view.texel * float(map_texels()) * (view.perspective == 1u ? distance : 1.0));
}

// Distance along the light's view; for directional lights, from the near plane.
float lamp_distance(ShadowView view, float depth) {
    return map_distance(view, depth) - (view.perspective == 1u ? 0.0 : view.near);
}

// Mean distance of blockers in front of the surface within `radius` (in map widths), from the lamp or a directional
// light's near plane; below 0: none.
float mean_blocker(ShadowView view, Receiver r, float radius, float turn) {
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < shadow.search_taps; ++i) {
        vec2 uv = r.place.xy + radius * disc_point(i, shadow.search_taps, turn);
        uv = (floor(uv * float(map_texels())) + 0.5) / float(map_texels());  // texel centre, where its depth is exact
        float stored = read_depth(uv, view.layer);
        if (stored <= plane_depth(r, uv)) continue;
        sum += lamp_distance(view, stored);
        count += 1.0;
    }
    return count > 0.0 ? sum / count : -1.0;
}

// Bilinear weighting of the four texels around uv.
float lit_between(Receiver r, uint layer, vec2 uv) {
    float size = float(map_texels());
    vec2 corner = floor(uv * size - 0.5) + 1.0, part = uv * size - corner + 0.5;
    vec4 lit = vec4(greaterThanEqual(plane_depths(r, corner / size), gather_depths(corner / size, layer)));
    vec2 columns = vec2(1.0 - part.x, part.x);
    return dot(lit, vec4(columns, columns.yx) * vec4(part.yy, 1.0 - part.yy));
}

// Search radius: blockers may lie as near as the map's near plane. `distance`: lamp_distance().
float search_radius(ShadowLight light, ShadowView view, float distance) {
    bool parallel = view.perspective == 0u;
    float widest = penumbra_width(distance, parallel ? 0.0 : view.near, light.size, parallel);
    return clamp(0.5 * widest * map_widths_per_metre(view, distance), 0.0, MAP_MARGIN);
}

float pcss(ShadowLight light, ShadowView view, Receiver r) {
    float receiver = lamp_distance(view, r.place.z), texel = 1.0 / float(map_texels()), turn = disc_turn(r.place.xy);
    float blocker = mean_blocker(view, r, max(search_radius(light, view, receiver), texel), turn);
    if (blocker < 0.0) return 1.0;
    float width = penumbra_width(receiver, blocker, light.size, view.perspective == 0u);
    float radius = clamp(0.5 * width * map_widths_per_metre(view, receiver), 0.5 * texel, MAP_MARGIN);
    float sum = 0.0;
    for (int i = 0; i < shadow.taps; ++i)
        sum += lit_between(r, view.layer, r.place.xy + radius * disc_point(i, shadow.taps, turn));
    return sum / float(shadow.taps);
}

// As in filter_pcf.glsl.
float filter_reach(ShadowLight light, ShadowView view, vec3 position) {
    float distance = lamp_distance(view, max(light_clip_position(view.to_clip, position).z, 0.0));
    return 1.0 + float(map_texels()) * search_radius(light, view, distance);
}

float filtered(ShadowLight light, ShadowView view, Receiver r, float texel, float pixel) {
    return pcss(light, view, r);
}
