// The same result as pcf(), a texel at a time.
#include "05_shadow_maps/map_reads.glsl"

// [pcf_single]
float pcf_single(Receiver r, uint layer, int kernel) {
    float texels = float(map_texels());
    vec2 begin = r.place.xy * texels - 0.5 * float(kernel), first = floor(begin), part = begin - first;
    float sum = 0.0;
    for (int y = 0; y <= kernel; ++y) {
        float row = y == 0 ? 1.0 - part.y : y == kernel ? part.y : 1.0;
        for (int x = 0; x <= kernel; ++x) {
            float column = x == 0 ? 1.0 - part.x : x == kernel ? part.x : 1.0;
            vec2 middle = (first + vec2(x, y) + 0.5) / texels;
            sum += row * column * float(plane_depth(r, middle) >= read_depth(middle, layer));
        }
    }
    return sum / float(kernel * kernel);
}
// [/pcf_single]
