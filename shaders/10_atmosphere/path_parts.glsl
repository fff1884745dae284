// Paths in parts, a dispatch for each: llvmpipe ends all loops of an invocation after 65,535 iterations together,
// without a message. Each part continues from the previous one's result. Compiled for passes that are IN_PARTS.
#include "10_atmosphere/path_part.h"

#ifdef IN_PARTS
layout(scalar) uniform PartBlock { PathPart part; };
layout(rgba32f) uniform image2D light_so_far;    // and the sum of the squares of each walk's contribution
layout(rgba32f) uniform image2D through_so_far;  // and the sum of the walks' contributions

struct SoFar {
    vec4 light, through;
};

SoFar so_far(ivec2 pixel) {
    if (part.begins != 0) return SoFar(vec4(0.0), vec4(1.0, 1.0, 1.0, 0.0));
    return SoFar(imageLoad(light_so_far, pixel), imageLoad(through_so_far, pixel));
}

void keep(SoFar found, ivec2 pixel) {
    if (part.ends != 0) return;
    unfinished = true;
    imageStore(light_so_far, pixel, found.light);
    imageStore(through_so_far, pixel, found.through);
}

// From the first of `all` equal pieces to before the last.
Path between(Path path, int first, int end, int all) {
    if (first == 0 && end == all) return path;
    Path piece = path_on(path, path.way * float(first) / float(all));
    piece.way = path.way * float(end - first) / float(all);
    return piece;
}

// Light scattered once, at this part's places of `all`.
void add_places(inout SoFar found, Path path, int all) {
    if (part.first_place == part.end_place) return;
    if (part.first_place == 0) found.through.rgb = vec3(1.0);
    Along more = in_scatter(part.end_place - part.first_place, between(path, part.first_place, part.end_place, all));
    found.light.rgb += found.through.rgb * more.light;
    found.through.rgb *= more.transmittance;
}
#endif
