// Displacement: each triangle is split into subdivide × subdivide, and points move to the height map's surface, which
// parallax only imitates. Drawn without indices: 3 * subdivide^2 vertices a triangle.
#include "common/mesh_input.glsl"
#include "01_obj/transform.glsl"
#include "04_surface_maps/surface_varyings.glsl"

layout(scalar) readonly buffer IndexBuffer { uint indices[]; };
layout(scalar) readonly buffer TangentBuffer { TangentFrame tangents[]; };
layout(scalar) uniform PartBlock {
    uint first_index;
    uint subdivide;
    float height_m;        // depth of the darkest texel, metres
    float wobble, scroll;  // for moving_uv()
} part;
uniform sampler2D height_map;

// Position of a sub-triangle's corner: (0, 0) at the first vertex, rows grow towards the other two.
uvec2 sub_corner(uint triangle, uint corner) {
    uint row = uint(sqrt(float(triangle)));
    if (row * row > triangle) --row;
    if ((row + 1u) * (row + 1u) <= triangle) ++row;
    uint place = triangle - row * row, column = place / 2u;
    if (place % 2u == 0u) return corner == 0u ? uvec2(row, column) : uvec2(row + 1u, column + corner - 1u);
    return corner == 0u ? uvec2(row, column) : uvec2(row + 2u - corner, column + 1u);
}

void main() {
    uint per_triangle = part.subdivide * part.subdivide;
    uint sub = uint(gl_VertexIndex) / 3u;
    uvec2 place = sub_corner(sub % per_triangle, uint(gl_VertexIndex) % 3u);
    vec2 b = vec2(place.x - place.y, place.y) / float(part.subdivide);
    uint first = part.first_index + 3u * (sub / per_triangle);
    uvec3 i = uvec3(indices[first], indices[first + 1u], indices[first + 2u]);
    float a = 1.0 - b.x - b.y;
    Vertex vertex;
    vertex.position = a * vertices[i.x].position + b.x * vertices[i.y].position + b.y * vertices[i.z].position;
    vertex.normal = normalize(a * vertices[i.x].normal + b.x * vertices[i.y].normal + b.y * vertices[i.z].normal);
    vertex.uv = a * vertices[i.x].uv + b.x * vertices[i.y].uv + b.y * vertices[i.z].uv;
    TangentFrame frame = tangents[i.x];
    frame.tangent = normalize(a * frame.tangent + b.x * tangents[i.y].tangent + b.y * tangents[i.z].tangent);
    set_varyings(vertex, frame, instances[gl_InstanceIndex]);
    set_rare_varyings(i, vec3(a, b));
#if MAPS_HEIGHT
    vec2 moved = moving_uv(uv, part.wobble, part.scroll, view.time_s);
    float depth = 1.0 - textureLod(height_map, image_uv(moved), 0.0).r;
    world_position -= part.height_m * depth * world_normal;
#endif
    gl_Position = world_to_clip(view.view_projection, world_position);
}
