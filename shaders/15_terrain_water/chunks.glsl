// Chunks of the ground: how far away they are, how wrong they are, and whether the view sees them.
#include "15_terrain_water/ground.glsl"

uniform sampler2D land_errors;
layout(scalar) uniform ChunkViewBlock {
    mat4 to_clip;
    vec3 from;           // metres, world space: origin of distances
    float metres_per_m;  // error that is allowed, for each metre of distance
    int fixed_level;     // draw this level everywhere; -1: by the error
} chunk_view;

// A point by samples from the map's corner.
vec3 chunk_point(ivec2 at) {
    return vec3(land_map.corner.x + land_map.spacing_m * float(at.x), texelFetch(land_heights, at, 0).r,
                land_map.corner.y + land_map.spacing_m * float(at.y));
}

float chunk_error_at(ivec2 chunk, int level) {
    ivec2 last = ivec2((1 << (land_map.top - level)) - 1);
    return texelFetch(land_errors, clamp(chunk, ivec2(0), last), level).r;
}

// The chunk's box, which holds all its samples.
void chunk_box(Chunk chunk, out vec3 low, out vec3 high) {
    float side = land_map.spacing_m * float(CHUNK_CELLS << chunk.level);
    vec2 corner = land_map.corner + side * vec2(chunk.x, chunk.z);
    vec2 heights = texelFetch(land_bounds, ivec2(chunk.x, chunk.z), chunk.level + CHUNK_LEVELS).rg;
    low = vec3(corner.x, heights.x, corner.y);
    high = vec3(corner.x + side, heights.y, corner.y + side);
}

// The level of the one chunk that covers the map.
int top_level() { return land_map.top; }

// The error that is allowed, for each metre of distance.
float chunk_limit() { return chunk_view.metres_per_m; }

// Metres from the eye to the nearest place of the chunk's box; 0 inside of it.
float chunk_distance(Chunk chunk) {
    vec3 low, high;
    chunk_box(chunk, low, high);
    return length(max(max(low - chunk_view.from, chunk_view.from - high), 0.0));
}

// The error of the chunk, metres. Never less than that of a chunk within.
float chunk_error(Chunk chunk) { return chunk_error_at(ivec2(chunk.x, chunk.z), chunk.level); }

// False: nothing of its box can be in the picture.
bool chunk_in_view(Chunk chunk) {
    vec3 low, high;
    chunk_box(chunk, low, high);
    ivec3 below = ivec3(0), above = ivec3(0);
    for (int i = 0; i < 8; ++i) {
        vec4 at = chunk_view.to_clip * vec4(mix(low, high, vec3(i & 1, (i >> 1) & 1, i >> 2)), 1.0);
        below += ivec3(lessThan(at.xyz, vec3(-at.w, -at.w, 0.0)));
        above += ivec3(greaterThan(at.xyz, vec3(at.w)));
    }
    return all(lessThan(max(below, above), ivec3(8)));
}
