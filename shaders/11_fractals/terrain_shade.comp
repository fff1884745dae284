// The ground, shaded in compute where a visibility buffer says that it is seen.
#include "05_shadow_maps/visible.glsl"
#include "11_fractals/terrain_color.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) readonly buffer GroundBuffer { vec3 ground_vertices[]; };
layout(scalar) readonly buffer IndexBuffer { uint indices[]; };
layout(scalar) uniform GridBlock { int hollow; } grid;  // where the indices of all rings but the first begin
layout(rgba16f) writeonly uniform image2D result;

// As texture() has it, from the same differences.
vec4 look_up(sampler2D map, vec2 uv, vec2 across, vec2 down) { return textureGrad(map, uv, across, down); }

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(at, size))) return;
    uvec2 seen = texelFetch(visible, at, 0).xy;
    if (seen.x == 0u) return;

    int ring = int(seen.x) - 1, vertices = (terrain_now.cells + 1) * (terrain_now.cells + 1);
    int first = (ring == 0 ? 0 : grid.hollow) + 3 * int(seen.y);
    vec4 corners[3];
    mat3 places;
    for (int i = 0; i < 3; ++i) {
        places[i] = ground_vertices[ring * vertices + int(indices[first + i])];
        corners[i] = view.view_projection * vec4(places[i], 1.0);
    }
    Shares s = shares_at(corners, at, size);
    vec3 color = terrain_color(places * s.here, places * s.across, places * s.down);
    imageStore(result, at, vec4(color, 1.0));
}
