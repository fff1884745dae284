// right
#include "05_shadow_maps/shadow_data.h"
float covered(float begin, int texel, int kernel) {
    return min(float(texel + 1), begin + float(kernel)) - max(float(texel), begin);
}
float pcf(Receiver r, uint layer, int kernel) {
    float n = float(map_texels());
    vec2 begin = r.place.xy * n - 0.5 * float(kernel);
    ivec2 first = ivec2(floor(begin));
    float lit = 0.0;
    for (int i = 0; i < (kernel + 1) * (kernel + 1) / 4; ++i) {
        ivec2 at = first + 2 * ivec2(i % ((kernel + 1) / 2), i / ((kernel + 1) / 2));
        vec2 corner = vec2(at + 1) / n;
        vec4 depth = gather_depths(corner, layer), plane = plane_depths(r, corner);
        vec2 x = vec2(covered(begin.x, at.x, kernel), covered(begin.x, at.x + 1, kernel));
        vec2 y = vec2(covered(begin.y, at.y, kernel), covered(begin.y, at.y + 1, kernel));
        if (depth.x <= plane.x) lit += x.x * y.y;
        if (depth.y <= plane.y) lit += x.y * y.y;
        if (depth.z <= plane.z) lit += x.y * y.x;
        if (depth.w <= plane.w) lit += x.x * y.x;
    }
    return lit / float(kernel * kernel);
}
