// Rays through a city: from block to block of its grid, and through the boxes of each.
#include "15_terrain_water/city_data.h"
#include "15_terrain_water/ground.glsl"

layout(scalar) readonly buffer CityBoxesBlock { CityBox city_boxes[]; };
layout(scalar) readonly buffer CityCellsBlock { uvec2 city_cells[]; };  // first box and number of boxes, row by row
layout(scalar) uniform CityGridBlock { CityGrid city_grid; };

struct CityHit {
    float t;  // in lengths of the ray's direction; below 0: none
    uint box;
    vec3 local;   // metres from the box's middle, in its own axes
    vec3 normal;  // in world space
};

// Between two times a slab is crossed; a ray along it is inside all the time, or never.
vec2 slab(float from, float step, float half_size) {
    float inverse = 1.0 / (abs(step) < 1e-12 ? 1e-12 : step);
    vec2 t = vec2(-half_size - from, half_size - from) * inverse;
    return vec2(min(t.x, t.y), max(t.x, t.y));
}

void meet_box(uint index, vec3 from, vec3 along, inout CityHit hit) {
    CityBox box = city_boxes[index];
    float c = cos(box.yaw), s = sin(box.yaw);
    vec2 away = box.place - city_grid.middle, at = from.xz - vec2(c * away.x - s * away.y, s * away.x + c * away.y);
    vec2 x = slab(at.x, along.x, box.half_size.x), z = slab(at.y, along.z, box.half_size.z);
    float enters = max(max(x.x, z.x), 0.0), leaves = min(min(x.y, z.y), hit.t < 0.0 ? 1e30 : hit.t);
    if (enters >= leaves) return;
    float ground_m = land_height(box.place), height = from.y - (ground_m + box.base_m + box.half_size.y);
    vec2 y = slab(height, along.y, box.half_size.y);
    float first = max(enters, y.x);
    if (ground_m < 1.0 || first >= min(leaves, y.y) || first <= 0.0) return;
    vec3 own = first == y.x ? vec3(0.0, -sign(along.y), 0.0) : first == x.x ? vec3(-sign(along.x), 0.0, 0.0) : vec3(0.0, 0.0, -sign(along.z));
    hit = CityHit(first, index, vec3(at.x, height, at.y) + first * along, vec3(c * own.x + s * own.z, own.y, -s * own.x + c * own.z));
}

// The nearest box that a ray meets within `most` times its direction.
CityHit city_hit(vec3 origin, vec3 direction, float most) {
    CityHit hit = CityHit(-1.0, 0u, vec3(0.0), vec3(0.0));
    // In the axes of the blocks, centred at multiples of the pitch.
    float c = cos(city_grid.yaw), s = sin(city_grid.yaw);
    vec2 away = origin.xz - city_grid.middle;
    vec3 from = vec3(c * away.x - s * away.y, origin.y, s * away.x + c * away.y);
    vec3 along = vec3(c * direction.x - s * direction.z, direction.y, s * direction.x + c * direction.z);
    vec2 pitch = city_grid.pitch, half_size = (vec2(city_grid.most) + 0.5) * pitch;
    vec2 x = slab(from.x, along.x, half_size.x), z = slab(from.z, along.z, half_size.y);
    float t = max(max(x.x, z.x), 0.0), end = min(min(x.y, z.y), most);
    if (along.y > 0.0) end = min(end, (land_map.highest_m + city_grid.highest - from.y) / along.y);
    for (int i = 0; i < 512 && t < end; ++i) {
        // A little inside of the block that the ray enters.
        ivec2 cell = ivec2(floor((from.xz + (t + 1e-3) * along.xz) / pitch + 0.5)), at = cell + city_grid.most;
        if (any(lessThan(at, ivec2(0))) || any(greaterThan(at, 2 * city_grid.most))) break;
        uvec2 boxes = city_cells[at.y * (2 * city_grid.most.x + 1) + at.x];
        for (uint k = boxes.x; k < boxes.x + boxes.y; ++k) meet_box(k, from, along, hit);
        vec2 borders = (vec2(cell) + 0.5 * sign(along.xz)) * pitch;
        vec2 exits = mix((borders - from.xz) / along.xz, vec2(1e30), lessThan(abs(along.xz), vec2(1e-12)));
        t = max(min(exits.x, exits.y), t + 1e-3);
        if (hit.t >= 0.0 && hit.t <= t) break;
    }
    return hit.t <= most ? hit : CityHit(-1.0, 0u, vec3(0.0), vec3(0.0));
}
