// Rays through the ground: through the pyramid of greatest heights to the triangles of single cells.
#include "15_terrain_water/ground.glsl"

// Where the ray comes down through one of a cell's two triangles between t.x and t.y; below 0: nowhere. `at` and `step_t`
// are in samples along x and z, metres along y.
float meet_cell(ivec2 cell, vec3 at, vec3 step_t, vec2 t) {
    float b = land_sample(cell + ivec2(1, 0)), c = land_sample(cell + ivec2(0, 1));
    vec2 from = at.xz - vec2(cell);
    // The diagonal, where x + z = 1, parts the way into two; on each the ray's height over the plane is linear in t.
    float along = step_t.x + step_t.z, diagonal = along != 0.0 ? (1.0 - from.x - from.y) / along : t.y;
    diagonal = clamp(diagonal, t.x, t.y);
    for (int i = 0; i < 2; ++i) {
        vec2 part = i == 0 ? vec2(t.x, diagonal) : vec2(diagonal, t.y);
        vec2 middle = from + 0.5 * (part.x + part.y) * step_t.xz;
        vec3 plane;  // height at (0, 0), slopes
        if (middle.x + middle.y <= 1.0) {
            float a = land_sample(cell);
            plane = vec3(a, b - a, c - a);
        } else {
            float d = land_sample(cell + 1);
            plane = vec3(b + c - d, d - c, d - b);
        }
        float over = at.y - plane.x - dot(plane.yz, from), rate = step_t.y - dot(plane.yz, step_t.xz);
        float first = over + part.x * rate, last = over + part.y * rate;
        // A point below the ground by more than rounding was there before: it does not descend here.
        if (last <= 0.0 && first >= -1e-3 * (1.0 + abs(at.y) * 1e-2)) return clamp(rate < 0.0 ? -over / rate : part.x, part.x, part.y);
    }
    return -1.0;
}

// [march]
float march(vec3 eye, vec3 ray) {
    vec3 at = vec3(land_place(eye.xz), eye.y).xzy, step_t = vec3(ray.xz / land_map.spacing_m, ray.y).xzy;
    float side = float(land_map.samples - 1);
    step_t.xz = mix(step_t.xz, vec2(1e-12), lessThan(abs(step_t.xz), vec2(1e-12)));
    vec2 first = -at.xz / step_t.xz, second = (side - at.xz) / step_t.xz;
    vec2 enters = min(first, second), leaves = max(first, second);
    vec2 t = vec2(max(max(enters.x, enters.y), 0.0), min(leaves.x, leaves.y));
    if (t.x >= t.y) return -1.0;
    ivec2 last = ivec2(land_map.samples - 2), cell = clamp(ivec2(floor(at.xz + t.x * step_t.xz)), ivec2(0), last);
    int top = land_map.top + CHUNK_LEVELS, level = top;
    ivec2 forward = ivec2(greaterThan(step_t.xz, vec2(0.0)));
    for (int i = 0; i < 2048; ++i) {
        ivec2 block = cell >> level;
        vec2 exits = (vec2((block + forward) << level) - at.xz) / step_t.xz;
        float leave = min(min(exits.x, exits.y), t.y);
        float lowest = at.y + step_t.y * (step_t.y > 0.0 ? t.x : leave);
        if (lowest <= texelFetch(land_bounds, block, level).g) {
            if (level > 0) {
                --level;
                continue;
            }
            float hit = meet_cell(cell, at, step_t, vec2(t.x, leave));
            if (hit >= 0.0) return hit;
        }
        // Into the next block: along the axis by which the ray leaves exactly, along the other wherever it is.
        if (leave >= t.y) return -1.0;
        ivec2 next = clamp(ivec2(floor(at.xz + leave * step_t.xz)), block << level, ((block + 1) << level) - 1);
        ivec2 beyond = mix((block << level) - 1, (block + 1) << level, equal(forward, ivec2(1)));
        if (exits.x <= exits.y)
            next.x = beyond.x;
        else
            next.y = beyond.y;
        cell = next;
        if (any(lessThan(cell, ivec2(0))) || any(greaterThan(cell, last))) return -1.0;
        t.x = max(leave, t.x);
        level = min(level + 1, top);
    }
    return -1.0;
}
// [/march]
