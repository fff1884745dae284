// Solution of 05.pcf.
#include "05_shadow_maps/shadow_data.h"

float pcf(Receiver r, uint layer, int kernel) {
    float texels = float(map_texels());
    vec2 begin = r.place.xy * texels - 0.5 * float(kernel), first = floor(begin), part = begin - first;
    float sum = 0.0;
    for (int y = 0; y <= kernel; y += 2) {
        vec2 rows = vec2(y == 0 ? 1.0 - part.y : 1.0, y + 1 == kernel ? part.y : 1.0);
        for (int x = 0; x <= kernel; x += 2) {
            vec2 columns = vec2(x == 0 ? 1.0 - part.x : 1.0, x + 1 == kernel ? part.x : 1.0);
            vec2 corner = (first + vec2(x, y) + 1.0) / texels;
            vec4 lit = vec4(greaterThanEqual(plane_depths(r, corner), gather_depths(corner, layer)));
            sum += dot(lit, vec4(columns, columns.yx) * rows.yyxx);
        }
    }
    return sum / float(kernel * kernel);
}
