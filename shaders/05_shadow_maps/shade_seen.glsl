// Main function of compute shaders that shade a visibility buffer. The includer defines seen_color(), which reads
// varyings as a fragment shader does.
#define SEEN
#include "04_surface_maps/plain_draw.glsl"

// Stand-ins for varyings: values of one corner, then interpolated ones.
vec3 world_position, world_normal, world_tangent;
float handedness, cos_uv;
vec2 metres_per_uv, uv;
uint material_index, item;

// Screen-space derivatives of the stand-ins.
vec3 change_across, change_down;  // derivatives of the position
vec3 winding_normal;              // normal of the triangle's front face, any length
vec2 uv_across, uv_down;

vec2 moved_across(vec2 moved, float time_s);
vec2 moved_down(vec2 moved, float time_s);
vec3 position_across() { return change_across; }
vec3 position_down() { return change_down; }
#if MAPS_SECOND_UVS
vec2 second_uv, second_uv_across, second_uv_down;
vec2 second_across() { return second_uv_across; }
vec2 second_down() { return second_uv_down; }
#endif
#if MAPS_COLORS
vec4 vertex_color;
#endif

#include "common/structs.h"
#include "04_surface_maps/surface_varyings.glsl"
#include "05_shadow_maps/visible.glsl"

layout(scalar) readonly buffer VertexBuffer { Vertex vertices[]; };
layout(scalar) readonly buffer TangentBuffer { TangentFrame tangents[]; };
layout(scalar) readonly buffer InstanceBuffer { Instance instances[]; };
layout(scalar) readonly buffer IndexBuffer { uint indices[]; };
layout(scalar) uniform SeenBlock {
    uint first_item, items;  // items of the shaded batch
    uint first_index;        // first index of the mesh's part
} seen;

// Sets varyings and gl_FragCoord; false if the pixel shows another batch.
bool look_up(ivec2 pixel, ivec2 size, mat4 view_projection, out vec4 frag_coord) {
    uvec2 id = texelFetch(visible, pixel, 0).xy;
    item = id.x - 1u;
    if (id.x == 0u || item - seen.first_item >= seen.items) return false;

    vec4 corners[3];
    mat3 positions, normals, tangent_vectors;
    mat3x2 metres, uvs;
    vec3 hands, cosines;
    uvec3 numbers;
    for (int i = 0; i < 3; ++i) {
        uint number = numbers[i] = indices[seen.first_index + 3u * id.y + uint(i)];
        set_varyings(vertices[number], tangents[number], instances[item]);
        corners[i] = world_to_clip(view_projection, world_position);
        positions[i] = world_position;
        normals[i] = world_normal;
        tangent_vectors[i] = world_tangent;
        metres[i] = metres_per_uv;
        uvs[i] = uv;
        hands[i] = handedness;
        cosines[i] = cos_uv;
    }
    winding_normal = cross(positions[1] - positions[0], positions[2] - positions[0]);
    if (determinant(mat3(instances[item].model)) < 0.0) winding_normal = -winding_normal;
    Shares s = shares_at(corners, pixel, size);
    world_position = positions * s.here;
    change_across = positions * s.across;
    change_down = positions * s.down;
    uv = uvs * s.here;
    uv_across = uvs * s.across;
    uv_down = uvs * s.down;
    world_normal = normals * s.here;
    world_tangent = tangent_vectors * s.here;
    metres_per_uv = metres * s.here;
    handedness = dot(hands, s.here);
    cos_uv = dot(cosines, s.here);
#if MAPS_SECOND_UVS
    set_rare_varyings(numbers, s.across);
    second_uv_across = second_uv;
    set_rare_varyings(numbers, s.down);
    second_uv_down = second_uv;
#endif
    set_rare_varyings(numbers, s.here);
    vec4 clip = world_to_clip(view_projection, world_position);
    frag_coord = vec4(vec2(pixel) + 0.5, clip.z / clip.w, 1.0 / clip.w);
    return true;
}

#include "04_surface_maps/surface_maps.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f) writeonly uniform image2D result;

// Animated texture coordinates.
vec2 moved_across(vec2 moved, float time_s) {
    return moving_uv(uv + uv_across, maps.wobble, maps.scroll, time_s) - moved;
}
vec2 moved_down(vec2 moved, float time_s) {
    return moving_uv(uv + uv_down, maps.wobble, maps.scroll, time_s) - moved;
}

// Linear radiance towards the eye, and alpha.
vec4 seen_color(vec4 frag_coord);

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    vec4 frag_coord;
    if (any(greaterThanEqual(pixel, size)) || !look_up(pixel, size, view.view_projection, frag_coord)) return;
    imageStore(result, pixel, seen_color(frag_coord));
}
