// right
#include "07_mipmaps/source.glsl"

vec4 box_2x2(ivec2 at) {
    // A loop over what is there, divided by how much that is.
    ivec2 size = source_size(), last = min(2 * at + 1, size - 1);
    vec4 sum = vec4(0.0);
    float count = 0.0;
    for (int y = 2 * at.y; y <= last.y; ++y)
        for (int x = 2 * at.x; x <= last.x; ++x) {
            sum += texel(ivec2(x, y));
            count += 1.0;
        }
    return sum / count;
}
