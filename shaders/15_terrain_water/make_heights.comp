// Heights of the ground: the source between its samples, and added detail.
#include "15_terrain_water/land_data.h"
#include "11_fractals/eroded_fbm.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar) uniform LandSourceBlock { LandSource land_source; };
uniform sampler2D source;
layout(r32f) writeonly uniform image2D result;

// Catmull and Rom's weights of four samples in a row, and their derivative: through every sample, without an edge there.
vec4 weights_at(float t) {
    return 0.5 * vec4(t * (-1.0 + t * (2.0 - t)), 2.0 + t * t * (3.0 * t - 5.0), t * (1.0 + t * (4.0 - 3.0 * t)), t * t * (t - 1.0));
}
vec4 slopes_at(float t) {
    return 0.5 * vec4(-1.0 + t * (4.0 - 3.0 * t), t * (9.0 * t - 10.0), 1.0 + t * (8.0 - 9.0 * t), t * (3.0 * t - 2.0));
}

// Height, and its slopes along the source's x and y, a sample.
vec3 source_at(vec2 place) {
    ivec2 last = textureSize(source, 0) - 1;
    place = clamp(place, vec2(0.0), vec2(last));
    ivec2 cell = ivec2(place);
    vec2 offset = place - vec2(cell);
    vec4 wx = weights_at(offset.x), wy = weights_at(offset.y), sx = slopes_at(offset.x), sy = slopes_at(offset.y);
    vec3 sum = vec3(0.0);
    for (int y = 0; y < 4; ++y) {
        vec4 row;
        for (int x = 0; x < 4; ++x) row[x] = texelFetch(source, clamp(cell + ivec2(x, y) - 1, ivec2(0), last), 0).r;
        sum += vec3(wy[y] * dot(wx, row), wy[y] * dot(sx, row), sy[y] * dot(wx, row));
    }
    return sum;
}

vec3 noise_at(vec2 place_m, float wave_m, float octaves, float erosion) {
    vec2 place = place_m / wave_m, whole = floor(place);
    return eroded_fbm(ivec2(whole), place - whole, octaves, erosion, 0.5);
}

// Steps of rock: level ground, then a wall, every `band` metres.
float terraced(float height, float band) {
    float at = height / band, whole = floor(at), wall = smoothstep(0.42, 0.58, at - whole);
    return band * (whole + mix(0.35 * (at - whole), 0.65 + 0.35 * (at - whole), wall));
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, ivec2(land_source.samples)))) return;
    vec2 place = land_source.place_m + land_source.spacing_m * vec2(at);
    vec3 from = source_at(land_source.first + land_source.step * vec2(at));
    float height = land_source.height_scale * (from.x - land_source.datum_m);
    float slope = land_source.height_scale * length(from.yz * land_source.step) / land_source.spacing_m;

    // Slopes erode to gullies and ribs; level ground is filled by sediment.
    float steep = smoothstep(0.03, 0.4, slope);
    if (land_source.detail_m > 0.0) {
        float octaves = clamp(log2(900.0 / (2.0 * land_source.spacing_m)) / 1.161, 1.0, 8.0);
        float ribs = noise_at(place, 900.0, octaves, 1.2).x;
        height += land_source.detail_m * (0.12 + steep) * ribs;
    }
    if (land_source.cliffs > 0.0) {
        float bend = 0.35 * land_source.cliff_m * noise_at(place + 7000.0, 1700.0, 4.0, 0.0).x;
        height = mix(height, terraced(height + bend, land_source.cliff_m) - bend, land_source.cliffs * smoothstep(0.1, 0.35, slope));
    }

    if (land_source.plain.z > 0.0) {
        float away = length(place - land_source.plain.xy) + 0.12 * land_source.plain.z * noise_at(place, 1300.0, 3.0, 0.0).x;
        height = mix(land_source.plain.w + 0.004 * height, height, smoothstep(0.75, 1.15, away / land_source.plain.z));
    }
    if (land_source.edge_m > 0.0) {
        vec2 inward = vec2(min(at, land_source.samples - 1 - at)) * land_source.spacing_m;
        float edge = min(inward.x, inward.y) / land_source.edge_m;
        height = mix(-60.0, height, smoothstep(0.0, 1.0, edge));
    }
    imageStore(result, at, vec4(height));
}
