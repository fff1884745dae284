// Conservative test whether a light reaches a cell of lights_grid: false positives only.
#include "03_attenuation/cone_reaches_ball.glsl"
#include "03_attenuation/light_data.h"

struct Cell {
    vec3 lower, upper;  // metres: a box in the camera's space (right, up, forward) that holds the cell
    vec2 slopes_x;      // x / z of the left and right side
    vec2 slopes_y;      // y / z of the lower and upper side
    float margin;       // above the rounding error, metres
};

// Cell of a tile between two depths in metres.
Cell cell_between(uvec2 tile, float near, float far) {
    vec2 low = lights_grid.origin + vec2(tile * lights_grid.tile_px);
    vec2 high = lights_grid.origin + min(vec2((tile + 1u) * lights_grid.tile_px), lights_grid.size);
    Cell cell;
    cell.slopes_x = (2.0 * vec2(low.x, high.x) / lights_grid.whole.x - 1.0) * lights_grid.tan_half.x;
    cell.slopes_y = (1.0 - 2.0 * vec2(high.y, low.y) / lights_grid.whole.y) * lights_grid.tan_half.y;
    cell.margin = 1e-3 * (1.0 + far);
    vec2 left_bottom = vec2(cell.slopes_x.x, cell.slopes_y.x), right_top = vec2(cell.slopes_x.y, cell.slopes_y.y);
    cell.lower = vec3(min(left_bottom * near, left_bottom * far), near) - cell.margin;
    cell.upper = vec3(max(right_top * near, right_top * far), far) + cell.margin;
    return cell;
}

vec3 to_camera(vec3 v) { return vec3(dot(v, lights_grid.right), dot(v, lights_grid.up), dot(v, lights_grid.forward)); }

// [light_reaches_cell]
bool light_reaches_cell(LightData light, Cell cell) {
    if (light.kind == LIGHT_DIRECTIONAL) return true;
    float radius = influence_radius(light, lights_grid.threshold);
    if (radius == 0.0) return false;
    vec3 center = to_camera(light.position - lights_grid.eye);
    vec3 gap = center - clamp(center, cell.lower, cell.upper);
    if (dot(gap, gap) > radius * radius) return false;
    // The box exceeds the frustum-shaped cell; the cell's four side planes through the eye reject what lies in between.
    vec4 slopes = vec4(cell.slopes_x, cell.slopes_y);
    vec4 beyond = (vec4(center.xx, center.yy) - slopes * center.z) * inversesqrt(1.0 + slopes * slopes);
    if (max(max(-beyond.x, beyond.y), max(-beyond.z, beyond.w)) > radius + cell.margin) return false;
    if (light.kind == LIGHT_POINT) return true;
    vec3 middle = 0.5 * (cell.lower + cell.upper);
    return cone_reaches_ball(middle - center, distance(middle, cell.upper), to_camera(light.direction), light.cos_outer);
}
// [/light_reaches_cell]
