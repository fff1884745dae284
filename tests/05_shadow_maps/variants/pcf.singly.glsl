// wrong: single texels
#include "05_shadow_maps/shadow_data.h"
float pcf(Receiver r, uint layer, int kernel) {
    float texels = float(map_texels());
    vec2 begin = r.place.xy * texels - 0.5 * float(kernel), first = floor(begin), part = begin - first;
    float sum = 0.0;
    for (int y = 0; y <= kernel; ++y)
        for (int x = 0; x <= kernel; ++x) {
            vec2 middle = (first + vec2(x, y) + 0.5) / texels;
            float w = (x == 0 ? 1.0 - part.x : x == kernel ? part.x : 1.0) * (y == 0 ? 1.0 - part.y : y == kernel ? part.y : 1.0);
            sum += w * float(r.place.z + dot(r.slope, middle - r.place.xy) >= read_depth(middle, layer));
        }
    return sum / float(kernel * kernel);
}
