// A thread for each chunk of each level, the finest first.
#include "15_terrain_water/chunk_level.glsl"

layout(local_size_x = 64) in;

void main() {
    int left = int(gl_GlobalInvocationID.x);
    for (int level = 0; level <= top_level(); ++level) {
        int side = 1 << (top_level() - level);
        if (left < side * side) {
            chunk_level(Chunk(left % side, left / side, level));
            return;
        }
        left -= side * side;
    }
}
