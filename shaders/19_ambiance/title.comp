// Titles: letters of a typeface with a dark outline, drawn over the picture in linear light.
#include "19_ambiance/glyph.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar) readonly buffer GlyphBuffer { Glyph glyphs[]; };
uniform sampler2D distances;
layout(rgba16f) uniform image2D picture;
layout(scalar) uniform TitleBlock {
    vec2 first;      // pixel of the picture at which the dispatch begins
    vec2 end;
    vec2 origin;     // pixel of the line's beginning, in the whole picture
    float scale;     // pixels of a capital's height
    float strength;  // 0 to 1
    uint begin, count;
} title;

// Heights of a capital by which a place lies within the nearest letter; negative outside.
float within_letter(vec2 at) {
    float most = -GLYPH_RANGE;
    for (uint i = 0u; i < title.count; ++i) {
        Glyph glyph = glyphs[title.begin + i];
        if (any(lessThan(at, glyph.lower)) || any(greaterThan(at, glyph.upper))) continue;
        vec2 share = (at - glyph.lower) / (glyph.upper - glyph.lower);
        vec2 texel = mix(glyph.first, glyph.end, vec2(share.x, 1.0 - share.y));
        texel = clamp(texel, glyph.first + 0.5, glyph.end - 0.5);
        float stored = textureLod(distances, texel / vec2(textureSize(distances, 0)), 0.0).r;
        most = max(most, (2.0 * stored - 1.0) * GLYPH_RANGE);
    }
    return most;
}

// On any ground: white letters in a line of nearly black, in a shadow that fades.
void main() {
    ivec2 pixel = ivec2(title.first) + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(title.end)))) return;
    vec2 at = (vec2(pixel) + 0.5 - title.origin) / title.scale;
    at.y = -at.y;
    float within = within_letter(at), line = max(0.06, 1.0 / title.scale);
    float letter = clamp(within * title.scale + 0.5, 0.0, 1.0);
    float outline = clamp((within + line) * title.scale + 0.5, 0.0, 1.0);
    float shadow = 0.55 * smoothstep(-GLYPH_RANGE, 0.0, within);
    vec3 light = imageLoad(picture, pixel).rgb;
    light *= 1.0 - title.strength * mix(shadow, 0.92, outline);
    light = mix(light, vec3(0.95, 0.94, 0.92), letter * title.strength);
    imageStore(picture, pixel, vec4(light, 1.0));
}
