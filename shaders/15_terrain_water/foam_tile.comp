// A tile of foam: bubbles of three sizes, bright where two cells meet.
#include "15_terrain_water/voronoi.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(r16f) writeonly uniform image2D tile;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = imageSize(tile);
    if (any(greaterThanEqual(at, size))) return;
    vec2 uv = (vec2(at) + 0.5) / vec2(size);
    float bubbles = 0.0, weight = 0.5;
    for (int cells = 8; cells <= 32; cells *= 2) {
        vec2 f = voronoi(uv * float(cells), cells, 1);
        bubbles += weight * (1.0 - smoothstep(0.02, 0.35, f.y - f.x));
        weight *= 0.6;
    }
    imageStore(tile, at, vec4(clamp(bubbles, 0.0, 1.0)));
}
