// Titles: letters as strokes of a pen, drawn over the picture in linear light.
#include "19_ambiance/stroke.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) readonly buffer StrokeBuffer { Stroke strokes[]; };
layout(rgba16f) uniform image2D picture;
layout(scalar) uniform TitleBlock {
    vec2 first;      // pixel of the picture at which the dispatch begins
    vec2 end;
    vec2 origin;     // pixel of the first letter's lower left corner, in the whole picture
    float scale;     // pixels of a letter's height
    float strength;  // 0 to 1
    uint begin, count;
} title;

float distance_to(vec2 at, Stroke stroke) {
    vec2 along = stroke.to - stroke.from, off = at - stroke.from;
    float square = dot(along, along);
    return length(off - (square > 0.0 ? clamp(dot(off, along) / square, 0.0, 1.0) : 0.0) * along);
}

void main() {
    ivec2 pixel = ivec2(title.first) + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(title.end)))) return;
    vec2 at = (vec2(pixel) + 0.5 - title.origin) / title.scale;
    at.y = -at.y;
    float nearest = 1e3;
    for (uint i = 0u; i < title.count; ++i) nearest = min(nearest, distance_to(at, strokes[title.begin + i]));
    // A pen of 1/14 of the height with a dark rim, for bright backgrounds.
    float pen = clamp((0.036 - nearest) * title.scale + 0.5, 0.0, 1.0);
    float shade = 0.8 * exp(-25.0 * nearest * nearest);
    vec3 light = imageLoad(picture, pixel).rgb;
    light = mix(light * (1.0 - shade * title.strength), vec3(0.92, 0.9, 0.86), pen * title.strength);
    imageStore(picture, pixel, vec4(light, 1.0));
}
